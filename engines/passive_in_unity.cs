// The passive step for a script in C#, omega and the moments I about the principal axes; `flies` for a body that mostly
// flies. A test reads this file as C++.
// [passive]
static bool Near(float a, float b) { return Mathf.Abs(a - b) < 0.05f * a; }
static Vector3 Round(Vector3 v) { float x = v.x; v.x = v.y; v.y = v.z; v.z = x; return v; }

static Vector3 Passive(Vector3 I, Vector3 w, float h, bool flies = false) {
    if (flies && Near(I.x, I.y)) {  // nearly equal: a turn about the third axis; the energy swings by their difference
        float a = h * (2 * I.z / (I.x + I.y) - 1) * w.z, c = Mathf.Cos(a), s = Mathf.Sin(a), old = w.x;
        w.x = c * old - s * w.y;
        w.y = c * w.y + s * old;
        return w;
    }
    if (flies && (Near(I.y, I.z) || Near(I.z, I.x))) return Round(Round(Passive(Round(I), Round(w), h, flies)));
    float x = w.x, y = w.y, z = w.z, X = h * I.x * x, Y = h * I.y * y, Z = h * I.z * z;
    float yz = 1 / (I.y * I.z), zx = 1 / (I.z * I.x), xy = 1 / (I.x * I.y), l = X * X + Y * Y + Z * Z;
    float n = 1 + X * X * yz + Y * Y * zx + Z * Z * xy;
    w.x = (x + l * yz * x - h * (I.z - I.y) / I.x * y * z) / n;
    w.y = (y + l * zx * y - h * (I.x - I.z) / I.y * z * x) / n;
    w.z = (z + l * xy * z - h * (I.y - I.x) / I.z * x * y) / n;
    return w;
}
// [passive]
