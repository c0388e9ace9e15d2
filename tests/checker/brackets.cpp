// What the rewriter of answers is tried on.
bool f(double x, double v, double h) {
    const double mean = (x + v) / 2;
    return mean > h && x > 0;
}
