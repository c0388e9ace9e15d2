// Which gaps are tried.

// Says: Only gaps of an even number of frames are tried, and one: h is made a whole number of frames, but it is
//       half of the gap.
// Hint: The velocity is asked between two frames. May an odd number of frames lie between its positions?
namespace even_gaps_only {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0 || noise == 0) return jerk == 0 ? most : 1;
    const double half = std::round(std::cbrt(3 * noise / jerk) / frame);
    return 2 * half >= most ? most : std::max(1, 2 * static_cast<int>(half));
}

}  // namespace even_gaps_only
