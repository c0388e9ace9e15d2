// Which packs and lanes there are.

// Says: The body that goes changes places with the last one, and stays behind in the first of the lanes left
//       over.
// Hint: All lanes left over are copies of the body that is the last now, the first of them, too.
namespace goner_left_behind {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    const int left = n - 1, used = (left + width - 1) / width;
    for (int part = 0; part < 3; ++part)
        std::swap(packs[(i / width * 3 + part) * width + i % width], packs[(left / width * 3 + part) * width + left % width]);
    packs.resize(3 * width * used);
    for (int lane = n; lane < used * width; ++lane) copy(packs, width, left - 1, lane);
    return packs;
}

}  // namespace goner_left_behind

// Says: The last pack is taken away where it was full. It must go where it held one body alone.
// Hint: Count: with packs of 4, how many are there for 5 bodies, and for 4? And for 8 and 7?
namespace removed_when_full {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    copy(packs, width, n - 1, i);
    if (n % width == 0) packs.resize(packs.size() - static_cast<std::size_t>(3 * width));
    for (int lane = n - 1; lane < int(packs.size()) / 3; ++lane) copy(packs, width, std::max(n - 2, 0), lane);
    return packs;
}

}  // namespace removed_when_full

// Says: All bodies are taken for one big pack, with the x of all before the y of all. Each pack has its own x,
//       y and z.
// Hint: The first 3 × width numbers are the first pack. What stands behind its x?
namespace one_big_pack {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    const int lanes = int(packs.size()) / 3, left = n - 1, used = (left + width - 1) / width * width;
    std::vector<double> moved;
    for (int part = 0; part < 3; ++part)
        for (int lane = 0; lane < used; ++lane) {
            const int body = std::min(lane, left - 1);
            moved.push_back(packs[part * lanes + (body == i ? left : body)]);
        }
    return moved;
}

}  // namespace one_big_pack
