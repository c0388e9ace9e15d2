// A page opened from its file may not read other files, except scripts: so a panel's module becomes one.
//   live_pack NAME MODULE SCRIPT
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace {

std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace

int main(int count, char** words) {
    if (count != 4) return std::cerr << "usage: live_pack NAME MODULE SCRIPT\n", 2;
    std::ifstream in(words[2], std::ios::binary);
    const std::string module{std::istreambuf_iterator<char>(in), {}};
    if (!in || module.empty()) return std::cerr << words[2] << ": cannot be read\n", 2;
    std::ofstream out(words[3]);
    out << "liveModules[\"" << words[1] << "\"] = \"" << base64(module) << "\";\n";
    if (!out.flush()) return std::cerr << words[3] << ": cannot be written\n", 2;
}
