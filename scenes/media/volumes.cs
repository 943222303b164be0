// Makes the grids of the scenes beside it: `dotnet run scenes/media/volumes.cs` writes a cloud, a plume of smoke, and a fire with its temperatures, a byte for each point; and
// fibres, matrices of six numbers of two bytes for each point.
#:property PublishAot=false
#:property TieredCompilation=true
using System.Numerics;
using System.Runtime.CompilerServices;

string folder = Here();

// A cumulus: balls heaped on a flat base, whose surface noise folds.
Random random = new(11);
List<(Vector3 Middle, float Radius)> balls = [];
for (int i = 0; i < 150; i++)
{
    float angle = random.NextSingle() * MathF.Tau;
    float far = MathF.Sqrt(random.NextSingle());
    float height = MathF.Pow(random.NextSingle(), 1.3f) * (1 - (0.85f * far)) * (0.75f + (0.25f * MathF.Sin((3 * angle) + 1)));
    balls.Add((new(0.5f + (0.34f * far * MathF.Cos(angle)), 0.2f + (0.62f * height), 0.5f + (0.32f * far * MathF.Sin(angle))), 0.075f + (0.075f * (1 - far) * random.NextSingle())));
}

Save("cloud", 128, 80, 96, p =>
{
    float inside = balls.Max(b => b.Radius - Vector3.Distance(p * new Vector3(1, 0.72f, 0.8f), b.Middle * new Vector3(1, 0.72f, 0.8f)));
    float fold = MathF.Abs(Noise(p * 9, 5, 3) - 0.5f) + (0.5f * MathF.Abs(Noise(p * 23, 3, 4) - 0.5f));
    float floor = Smooth((p.Y - 0.13f - (0.03f * Noise(p * 11, 3, 5))) / 0.03f);
    return floor * Smooth((inside + 0.035f - (0.42f * fold)) / 0.02f);
});

// Smoke from a narrow source: it rises, sways, widens, curls and thins out.
Save("smoke", 72, 128, 72, p =>
{
    float height = p.Y;
    Vector3 curl = new(Noise(new Vector3(p.X * 3, (p.Y * 4) - 0.7f, p.Z * 3), 3, 21) - 0.5f, 0, Noise(new Vector3(p.X * 3, (p.Y * 4) + 9, p.Z * 3), 3, 22) - 0.5f);
    Vector3 at = p + (curl * (0.06f + (0.75f * height)));
    Vector2 middle = new(0.5f + (0.1f * height * MathF.Sin((5 * height) + 0.5f)) + (0.05f * height), 0.5f + (0.08f * height * MathF.Cos(6 * height)));
    float radius = 0.03f + (0.26f * MathF.Pow(height, 0.9f));
    float far = Vector2.Distance(new(at.X, at.Z), middle) / radius;
    float billow = Noise(new Vector3(at.X * 9, (at.Y * 7) - 3, at.Z * 9), 5, 31);
    float edge = Smooth((1 - far + (4f * (billow - 0.55f))) / 0.35f);
    return edge * Smooth(height / 0.02f) * Smooth((1 - height) / 0.25f) * (0.15f + (0.85f * MathF.Exp(-1.8f * height)));
});

// A fire: tongues that noise tears apart the higher they are; hottest within and below.
Save("fire", 64, 96, 64, p => Smooth(Flame(p) / 0.25f) * (1 - (0.7f * p.Y)));
Save("heat", 64, 96, 64, p => 0.45f + (0.55f * Smooth((Flame(p) + 0.15f) / 0.9f) * (1 - (0.45f * p.Y))));

// Fibres around the vertical axis, as of thread on a ball, and outwards, as of velvet.
Fibres("around", p => new(-p.Z, 0, p.X));
Fibres("outward", p => p);

// Above 0 where there is fire, and the more the deeper within.
float Flame(Vector3 p)
{
    float height = p.Y;
    Vector3 rising = new(p.X * 5, (p.Y * 3.2f) - 5, p.Z * 5);
    Vector3 sway = new(Noise(rising, 3, 51) - 0.5f, 0, Noise(rising + new Vector3(40, 0, 0), 3, 52) - 0.5f);
    Vector3 at = p + (sway * (0.08f + (0.55f * height)));
    float far = Vector2.Distance(new(at.X, at.Z), new(0.5f, 0.5f));
    float radius = 0.36f * MathF.Pow(1 - height, 0.75f) * Smooth((height + 0.12f) / 0.3f);
    float tongues = Noise(new Vector3(at.X * 10, (at.Y * 4) + 3, at.Z * 10), 4, 53) - 0.5f;
    return (1 - (far / MathF.Max(radius, 1e-3f)) + (tongues * (2 + (3.6f * height)))) * Smooth(height / 0.04f) * Smooth((1 - height) / 0.15f);
}

void Save(string name, int nx, int ny, int nz, Func<Vector3, float> density)
{
    byte[] bytes = new byte[nx * ny * nz];
    Parallel.For(0, nz * ny, row =>
    {
        for (int x = 0; x < nx; x++)
        {
            Vector3 at = new((x + 0.5f) / nx, ((row % ny) + 0.5f) / ny, ((row / ny) + 0.5f) / nz);
            bytes[(row * nx) + x] = (byte)MathF.Round(255 * Math.Clamp(density(at), 0, 1));
        }
    });
    File.WriteAllBytes(Path.Combine(folder, name + ".raw"), bytes);
    Console.WriteLine($"{name}.raw: {nx}×{ny}×{nz}");
}

// Of a fibre along a unit vector t: S = 1 − 0.98 t tᵀ, as large as can be from the side and nearly nothing along it.
void Fibres(string name, Func<Vector3, Vector3> direction)
{
    const int n = 16;
    using BinaryWriter writer = new(File.Create(Path.Combine(folder, name + ".raw")));
    for (int i = 0; i < n * n * n; i++)
    {
        Vector3 t = Vector3.Normalize(direction(new Vector3(i % n, i / n % n, i / (n * n)) - new Vector3((n - 1) / 2f)));
        float[] matrix = [1 - (0.98f * t.X * t.X), 1 - (0.98f * t.Y * t.Y), 1 - (0.98f * t.Z * t.Z), -0.98f * t.X * t.Y, -0.98f * t.X * t.Z, -0.98f * t.Y * t.Z];
        foreach (float number in matrix)
        {
            writer.Write((Half)number);
        }
    }

    Console.WriteLine($"{name}.raw: {n}×{n}×{n}×6");
}

static float Smooth(float t)
{
    t = Math.Clamp(t, 0, 1);
    return t * t * (3 - (2 * t));
}

// Octaves of value noise, each of half the height of the one before: ½ on average.
static float Noise(Vector3 p, int octaves, uint seed)
{
    (float sum, float height, float heights) = (0, 1, 0);
    for (int i = 0; i < octaves; i++)
    {
        sum += height * Value((p * (1 << i)) + new Vector3(17.3f * i), seed + (uint)i);
        heights += height;
        height *= 0.5f;
    }

    return sum / heights;
}

static float Value(Vector3 p, uint seed)
{
    (int x, int y, int z) = ((int)MathF.Floor(p.X), (int)MathF.Floor(p.Y), (int)MathF.Floor(p.Z));
    (float u, float v, float w) = (Smooth(p.X - x), Smooth(p.Y - y), Smooth(p.Z - z));
    float At(int i, int j, int k) => Mix(Mix((uint)(x + i) + (Mix((uint)(y + j) + (Mix((uint)(z + k) + seed) * 3)) * 5))) / 4294967295f;
    float Line(int j, int k) => float.Lerp(At(0, j, k), At(1, j, k), u);
    return float.Lerp(float.Lerp(Line(0, 0), Line(1, 0), v), float.Lerp(Line(0, 1), Line(1, 1), v), w);
}

static uint Mix(uint x)
{
    x = (x ^ (x >> 16)) * 0x7feb352d;
    x = (x ^ (x >> 15)) * 0x846ca68b;
    return x ^ (x >> 16);
}

static string Here([CallerFilePath] string path = "") => Path.GetDirectoryName(path)!;
