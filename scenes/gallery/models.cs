// Makes the models of the gallery's scenes and of those with caustics: `dotnet run scenes/gallery/models.cs` writes them beside the scenes.
#:property PublishAot=false
#:property TieredCompilation=true
using System.Numerics;
using System.Runtime.CompilerServices;

string folder = Here();

// Chess pieces: profiles from the bottom to the top, as radius and height; a square of the board is 1 wide.
Vector2[] foot = [new(0, 0), new(0.4f, 0), new(0.4f, 0), new(0.41f, 0.05f), new(0.4f, 0.1f), new(0.33f, 0.13f), new(0.33f, 0.13f),
    new(0.34f, 0.17f), new(0.31f, 0.2f)];
Vector2[] collar(float y, float r) => [new(r, y), new(r + 0.1f, y + 0.02f), new(r + 0.11f, y + 0.05f), new(r + 0.02f, y + 0.07f),
    new(r + 0.02f, y + 0.07f)];
Vector2[] ball(float y, float r, int from) => [.. Enumerable.Range(from, 17 - from).Select(i => Polar(r, i / 16f) + new Vector2(0, y))];
Save("pawn", Lathe([.. foot, new(0.2f, 0.3f), new(0.13f, 0.5f), new(0.11f, 0.62f), .. collar(0.64f, 0.1f), .. ball(0.86f, 0.19f, 4)]));
Mesh rook = Lathe([
    .. foot, new(0.24f, 0.3f), new(0.2f, 0.6f), new(0.19f, 0.82f), .. collar(0.84f, 0.17f), new(0.22f, 0.95f), new(0.27f, 1), new(0.27f,
        1), new(0.27f, 1.13f),
    new(0.27f, 1.13f), new(0.19f, 1.13f), new(0.19f, 1.13f), new(0.19f, 1.03f), new(0.19f, 1.03f), new(0, 1.03f)]);
for (int i = 0; i < 6; i++)
{
    rook.Wedge(0.19f, 0.27f, 1.13f, 1.23f, MathF.Tau * i / 6, MathF.Tau * (i + 0.62f) / 6);
}

Save("rook", rook);
Save("bishop", Lathe([
    .. foot, new(0.21f, 0.32f), new(0.14f, 0.6f), new(0.12f, 0.84f), .. collar(0.86f, 0.11f), .. collar(0.94f, 0.1f), new(0.14f, 1.03f),
        new(0.2f, 1.13f),
    new(0.2f, 1.21f), new(0.15f, 1.33f), new(0.07f, 1.44f), new(0.035f, 1.48f), .. ball(1.52f, 0.055f, 4)]));
Vector2[] tall = [.. foot, new(0.23f, 0.36f), new(0.155f, 0.7f), new(0.13f, 1.04f), .. collar(1.06f, 0.12f), .. collar(1.14f, 0.11f),
    new(0.13f, 1.24f)];
Mesh queen = Lathe([.. tall, new(0.17f, 1.42f), new(0.26f, 1.58f), new(0.26f, 1.58f), new(0.21f, 1.6f), new(0.17f, 1.57f), new(0.1f,
    1.63f), .. ball(1.7f, 0.07f, 5)]);
for (int i = 0; i < 9; i++)
{
    queen.Ball(Around(0.235f, 1.6f, i / 9f), 0.042f);
}

Save("queen", queen);
Mesh king = Lathe([.. tall, new(0.16f, 1.42f), new(0.23f, 1.58f), new(0.23f, 1.58f), new(0.2f, 1.62f), new(0.1f, 1.68f), new(0.05f,
    1.7f), new(0.05f, 1.7f), new(0, 1.71f)]);
king.Box(new(-0.03f, 1.68f, -0.03f), new(0.03f, 1.98f, 0.03f));
king.Box(new(-0.11f, 1.82f, -0.031f), new(0.11f, 1.88f, 0.031f));
Save("king", king);

// The knight: a turned foot, and a head of ellipses along a bent spine: height and depth of the middle, half depth, half width, tilt.
Mesh knight = Lathe([.. foot, new(0.3f, 0.24f), new(0.29f, 0.28f), new(0.29f, 0.28f), new(0, 0.29f)]);
float[][] spine = [
    [0.26f, 0.02f, 0.25f, 0.22f, 0], [0.4f, -0.03f, 0.23f, 0.18f, -5], [0.58f, -0.08f, 0.22f, 0.15f, 0], [0.76f, -0.09f, 0.21f, 0.14f,
        12], [0.93f, -0.05f, 0.2f, 0.14f, 30],
    [1.04f, 0.03f, 0.19f, 0.14f, 60], [1.05f, 0.13f, 0.17f, 0.135f, 88], [0.99f, 0.23f, 0.135f, 0.115f, 112], [0.9f, 0.32f, 0.105f,
        0.095f, 122], [0.83f, 0.385f, 0.09f, 0.085f, 126],
    [0.8f, 0.41f, 0.05f, 0.05f, 126]];
knight.Tube([.. Smooth(spine, 5).Select(s => (new Vector3(0, s[0], s[1]), Tilt(s[4]) * s[2], Vector3.UnitX * s[3]))]);
foreach (float side in new[] { -1f, 1f })
{
    knight.Tube([.. new[] { (1.12f, 0.05f, 0.055f), (1.2f, 0.03f, 0.05f), (1.27f, 0.015f, 0.03f), (1.31f, 0.01f, 0.008f) }
        .Select(e => (new Vector3(side * 0.075f, e.Item1, e.Item2), Vector3.UnitZ * e.Item3, Vector3.UnitX * e.Item3 * 0.6f))]);
    knight.Ball(new(side * 0.115f, 1.06f, 0.16f), 0.03f);
}

knight.Tube([.. Smooth(spine, 5).Skip(4).Take(26).Select((s, i) =>
    (new Vector3(0, s[0], s[1]) - (Tilt(s[4]) * s[2]), Tilt(s[4]) * (0.05f + (0.02f * (i % 4 / 2))),
        Vector3.UnitX * (0.045f - (0.001f * i))))]);

Save("knight", knight);

// A ball for materials: a sphere with a groove around it, on a turned stand.
Save("shader-ball", Lathe([.. Enumerable.Range(3, 12).Select(i => Polar(1, i / 32f) + new Vector2(0, 1.2f)), new(0.97f, 1.03f),
    new(0.97f, 1.03f),
    new(0.84f, 1.06f), new(0.84f, 1.06f), new(0.84f, 1.16f), new(0.84f, 1.16f), new(0.985f, 1.18f), new(0.985f, 1.18f),
    .. Enumerable.Range(17, 16).Select(i => Polar(1, i / 32f) + new Vector2(0, 1.2f))], 64));
Save("shader-stand", Lathe([new(0, 0), new(0.75f, 0), new(0.75f, 0), new(0.75f, 0.08f), new(0.75f, 0.08f), new(0.55f, 0.14f), new(0.46f,
    0.25f), new(0.46f, 0.35f), new(0.36f, 0.35f), new(0, 0.33f)], 64));

// A lantern of coloured panes: a net of rhombs around a turned shape, with lead along its threads; one mesh for each colour, and the lead.
float[] girths = [0.05f, 0.082f, 0.103f, 0.114f, 0.116f, 0.108f, 0.093f, 0.072f, 0.047f];
const int Panes = 12;
Vector3 knot(int i, int j) => Around(girths[i], 0.027f * i, (j + (0.5f * i)) / Panes);
string[] colours = ["ruby", "amber", "cobalt", "emerald"];
Mesh[] panes = [new(), new(), new(), new()];
Mesh lead = new();
for (int i = 0; i + 1 < girths.Length; i++)
{
    for (int j = 0; j < Panes; j++)
    {
        lead.Rod(knot(i, j), knot(i + 1, j), 0.0016f);
        lead.Rod(knot(i, j), knot(i + 1, j - 1), 0.0016f);
        // The lower half of one rhomb, and the upper half of the one below it on the right.
        panes[PaneColour(i, j)].Pane(knot(i, j), knot(i + 1, j - 1), knot(i + 1, j));
        panes[PaneColour(i - 1, j + 1)].Pane(knot(i, j), knot(i + 1, j), knot(i, j + 1));
    }
}

foreach ((string colour, Mesh pane) in colours.Zip(panes))
{
    Save($"lantern-{colour}", pane);
}

Save("lantern-lead", lead);

// A ball of mirrors in rows; each is about as wide as it is high.
Mesh facets = new();
const int FacetRows = 13;
for (int row = 0; row < FacetRows; row++)
{
    (Vector2 low, Vector2 high) = (Polar(1, (row + 0.04f) / FacetRows), Polar(1, (row + 0.96f) / FacetRows));
    int facetsInRow = Math.Max(4, (int)MathF.Round(2 * FacetRows * MathF.Sin(MathF.PI * (row + 0.5f) / FacetRows)));
    for (int j = 0; j < facetsInRow; j++)
    {
        (float from, float to) = ((j + 0.04f) / facetsInRow, (j + 0.96f) / facetsInRow);
        facets.Pane(Around(low.X, low.Y, from), Around(high.X, high.Y, from), Around(high.X, high.Y, to));
        facets.Pane(Around(low.X, low.Y, from), Around(high.X, high.Y, to), Around(low.X, low.Y, to));
    }
}

Save("mirror-ball", facets);

// A tree.
Mesh wood = new();
Mesh leaves = new();
Grow(wood, leaves, new Random(7), default, Vector3.UnitY, 1.15f, 0.13f, 6);
Save("tree-wood", wood);
Save("tree-leaves", leaves);

// Fruit, in decimetres, and what they lie in. An apple has five bumps below, a pear leans, a banana is bent and has five edges.
Save("apple", Lathe([new(0, 0.14f), new(0.08f, 0.1f), new(0.16f, 0.015f), new(0.22f, 0), new(0.31f, 0.07f), new(0.385f, 0.24f),
    new(0.41f, 0.42f), new(0.38f, 0.58f), new(0.29f, 0.7f), new(0.19f, 0.74f), new(0.1f, 0.7f), new(0.045f, 0.63f), new(0, 0.6f)], 48)
    .Bent(p => p * (1 + (0.05f * MathF.Exp(-5 * p.Y) * Lobes(p))) * new Vector3(1, 1 + (0.08f * p.X), 1)));
Save("pear", Lathe([new(0, 0.06f), new(0.07f, 0.02f), new(0.16f, 0), new(0.3f, 0.09f), new(0.39f, 0.32f), new(0.36f, 0.55f),
    new(0.25f, 0.78f), new(0.18f, 0.96f), new(0.14f, 1.08f), new(0.06f, 1.14f), new(0.02f, 1.11f), new(0, 1.1f)], 48)
    .Bent(p => new((p.X * (1 + (0.05f * p.Z))) + (0.11f * p.Y * p.Y), p.Y, p.Z)));
Save("lemon", Lathe([new(0, 0), new(0.05f, 0.01f), new(0.08f, 0.06f), new(0.18f, 0.13f), new(0.265f, 0.27f), new(0.28f, 0.4f),
    new(0.24f, 0.56f), new(0.13f, 0.69f), new(0.07f, 0.74f), new(0.055f, 0.81f), new(0, 0.83f)], 48)
    .Bent(p => p + new Vector3(0.03f * p.Y * p.Y, 0, 0)));
Save("banana", Lathe([new(0, -1), new(0.035f, -0.99f), new(0.04f, -0.95f), new(0.06f, -0.88f), new(0.14f, -0.72f), new(0.175f, -0.4f),
    new(0.185f, 0), new(0.175f, 0.4f), new(0.13f, 0.7f), new(0.06f, 0.85f), new(0.042f, 0.95f), new(0.045f, 1.1f), new(0, 1.11f)], 40)
    .Bent(p => p with { X = p.X * (1 + (0.045f * Lobes(p))), Z = p.Z * (1 + (0.045f * Lobes(p))) })
    .Bent(p => new((1.3f - p.X) * MathF.Cos(p.Y / 1.3f), (1.3f - p.X) * MathF.Sin(p.Y / 1.3f), p.Z)));
Save("bowl", Lathe([new(0, 0.1f), new(0.5f, 0.1f), new(0.5f, 0.1f), new(0.52f, 0), new(0.58f, 0), new(0.57f, 0.1f), new(0.6f, 0.13f),
    new(0.6f, 0.13f), new(0.98f, 0.33f), new(1.3f, 0.65f), new(1.5f, 0.98f), new(1.54f, 1.02f), new(1.52f, 1.045f), new(1.46f, 1.01f),
    new(1.24f, 0.68f), new(0.92f, 0.39f), new(0.5f, 0.23f), new(0, 0.16f)], 96));
Mesh jug = Lathe([new(0, 0), new(0.55f, 0), new(0.55f, 0), new(0.58f, 0.05f), new(0.55f, 0.1f), new(0.5f, 0.13f), new(0.5f, 0.13f),
    new(0.75f, 0.45f), new(0.88f, 0.95f), new(0.8f, 1.45f), new(0.5f, 1.9f), new(0.38f, 2.2f), new(0.38f, 2.2f), new(0.42f, 2.24f),
    new(0.38f, 2.28f), new(0.38f, 2.28f), new(0.4f, 2.55f), new(0.52f, 2.8f), new(0.54f, 2.84f), new(0.5f, 2.84f), new(0.37f, 2.55f),
    new(0.34f, 2.2f), new(0, 1.9f)], 72)
    .Bent(p => p with { X = p.X * (1 - (0.25f * MathF.Exp(-40 * (p.Y - 2.84f) * (p.Y - 2.84f)) * MathF.Sign(p.X))) });
jug.Add(Swept(t => new(0.42f + (0.85f * MathF.Sin(MathF.PI * t * 0.93f)), 2.5f - (1.35f * t) + (0.3f * MathF.Sin(MathF.PI * t)), 0),
    t => 0.07f + (0.02f * MathF.Cos(MathF.Tau * t)), 24, 16));
Save("jug", jug);
Mesh cloth = new();
cloth.Sheet(56, 72, (u, v) =>
{
    (float x, float z) = ((6.6f * v) - 3.3f, (4.4f * u) - 1.9f);
    float crease = MathF.Sin((0.75f * x) + (0.4f * z) + MathF.Sin(0.6f * z));
    float fold = (0.06f * MathF.Exp(-25 * crease * crease)) + (0.03f * MathF.Sin((2.3f * z) + (0.9f * x) + (2 * MathF.Sin(0.7f * x)))
        * MathF.Sin(1.3f * x));
    float over = MathF.Max(z - 2.05f, 0);
    return new(x + (0.12f * MathF.Sin(3 * x) * over), 0.045f + fold - (1.6f * over * over) - (0.1f * over),
        z - (0.6f * over) + (over * 0.3f * MathF.Sin(4.2f * x)));
});
Save("cloth", cloth);

// One turn of a winding staircase, in metres: twenty steps around a well, each higher by 0.17, with its balusters; string and rail.
const float Well = 1.05f, Outside = 2.9f, Rise = 0.17f, Turn = 20 * Rise;
(Mesh steps, Mesh carpet, Mesh risers, Mesh balusters) = (new(), new(), new(), new());
for (int i = 0; i < 20; i++)
{
    (float from, float to, float y) = (-MathF.Tau * (i + 1) / 20, -MathF.Tau * i / 20, i * Rise);
    steps.Wedge(Well + 0.03f, Outside, y - 0.04f, y, from, to + 0.02f);
    risers.Wedge(Well + 0.03f, Outside, y - Rise - 0.04f, y - 0.04f, from + 1e-3f, to);
    carpet.Wedge(1.45f, 2.35f, y - Rise + 0.012f, y + 0.012f, from, to + 0.026f);
    foreach (float at in new[] { 0.25f, 0.75f })
    {
        balusters.Add(Lathe([new(0.013f, -0.02f), new(0.013f, 0.36f), new(0.013f, 0.36f), new(0.024f, 0.42f), new(0.024f, 0.42f),
            new(0.034f, 0.47f), new(0.034f, 0.47f), new(0.024f, 0.52f), new(0.024f, 0.52f), new(0.013f, 0.58f), new(0.013f, 0.58f),
            new(0.013f, 0.98f)], 8)
            .Bent(p => p + Around(Well + 0.05f, y, -(i + at) / 20)));
    }
}

Save("stairs-steps", steps);
Save("stairs-risers", risers);
Save("stairs-carpet", carpet);
Save("stairs-balusters", balusters);
Save("stairs-rail", Swept(t => Around(Well + 0.05f, 0.99f - (Rise / 2) + (Turn * t), -t), _ => 0.04f, 96, 12));
Mesh band = new();
foreach ((float r, float y, float dr, float dy) in new[]
    { (Well, -0.34f, 0f, 0.4f), (Well, 0.06f, 0.1f, 0f), (Well + 0.1f, 0.06f, 0f, -0.4f) })
{
    band.Sheet(1, 96, (u, v) => Around(r + (u * dr), y - (Rise / 2) + (u * dy) + (Turn * v), -v));
}

band.Sheet(96, 1, (u, v) => Around(Well + (v * (Outside - Well)), (Turn * u) - (Rise / 2) - 0.34f, -u));
Save("stairs-string", band);

// The ground of a town around a bay, in metres, a boat, and the sky after sunset: a picture of all directions, in Radiance's format.
Mesh ground = new();
ground.Sheet(70, 90, (u, v) => Land((v - 0.5f) * 260, u * (0.4f + (0.6f * u)) * 190));
Save("town-ground", ground);
Mesh quay = new();
quay.Sheet(1, 90, (u, v) => Land((v - 0.5f) * 260, 0) - new Vector3(0, 3 * u, 0));
Save("town-quay", quay);
Mesh boat = new();
boat.Sheet(14, 24, (u, v) =>
{
    float z = (2 * v) - 1;
    float width = 0.85f * MathF.Pow(MathF.Max(1 - MathF.Pow(MathF.Abs(z), 2.4f), 0), 0.8f);
    float turn = MathF.PI * u;
    return new(width * MathF.Cos(turn), (0.25f * z * z) + (0.75f * (1 - MathF.Pow(MathF.Abs(MathF.Sin(turn)), 0.6f))), 2.6f * z);
});
Save("boat", boat);
using (BinaryWriter writer = new(File.Create(Path.Combine(folder, "dusk.hdr"))))
{
    writer.Write("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n".ToCharArray());
    for (int i = 0; i < 64 * 128; i++)
    {
        float height = 1 - ((i / 128) + 0.5f) / 32;
        float glow = 0.5f + (0.5f * MathF.Cos(MathF.Tau * (((i % 128) + 0.5f) / 128 - 0.57f)));
        float above = MathF.Max(height, 0);
        Vector3 sky = Vector3.Lerp(new(0.03f, 0.06f, 0.16f), new(0.004f, 0.01f, 0.04f), MathF.Min(1.4f * above, 1))
            + (new Vector3(0.6f, 0.2f, 0.06f) * glow * glow * MathF.Exp(-7 * above))
            + (new Vector3(0.1f, 0.05f, 0.09f) * glow * MathF.Exp(-4 * above));
        Vector3 color = height < 0 ? new(0.004f, 0.006f, 0.01f) : sky;
        int exponent = (int)MathF.Ceiling(MathF.Log2(MathF.Max(color.X, MathF.Max(color.Y, color.Z))) + 0.01f);
        Vector3 mantissa = color * MathF.Pow(2, 8 - exponent);
        writer.Write([(byte)mantissa.X, (byte)mantissa.Y, (byte)mantissa.Z, (byte)(128 + exponent)]);
    }
}

// What stands in a room, in metres: a cushion of extent 2, of which an armchair is upholstered, curtains, a vase of tulips, a table.
Mesh cushion = new();
cushion.Sheet(28, 48, (u, v) =>
{
    float Soft(float x) => MathF.Sign(x) * MathF.Pow(MathF.Abs(x), 0.45f);
    (float sin, float cos) = MathF.SinCos(MathF.Tau * -v);
    (float up, float outwards) = MathF.SinCos(MathF.PI * (u - 0.5f));
    return new(Soft(outwards) * Soft(cos), -Soft(up), Soft(outwards) * Soft(sin));
});
Save("cushion", cushion);
Mesh curtain = new();
curtain.Sheet(16, 120, (u, v) => new(
    0.62f * v * (1 - (0.3f * MathF.Exp(-20 * (u - 0.62f) * (u - 0.62f)))),
    2.42f * (1 - u),
    (0.045f + (0.02f * u)) * MathF.Sin((MathF.Tau * 7 * v) + (0.6f * MathF.Sin(5 * u)) + (1.5f * v))));
Save("curtain", curtain);
Save("vase", Lathe([new(0, 0), new(0.05f, 0), new(0.05f, 0), new(0.055f, 0.008f), new(0.085f, 0.07f), new(0.09f, 0.12f),
    new(0.06f, 0.19f), new(0.034f, 0.24f), new(0.04f, 0.275f), new(0.052f, 0.29f), new(0.046f, 0.288f), new(0.03f, 0.24f),
    new(0, 0.2f)], 48));
(Mesh stems, Mesh blossoms) = (new(), new());
for (int i = 0; i < 11; i++)
{
    Vector3 lean = Around(0.05f + (0.014f * i), 0, i * 0.382f);
    Vector3 Stem(float t) => new(lean.X * t * (0.6f + (0.8f * t)), 0.2f + ((0.34f - (0.012f * i)) * t), lean.Z * t * (0.6f + (0.8f * t)));
    stems.Add(Swept(Stem, _ => 0.0035f, 8, 6));
    blossoms.Add(Lathe([new(0, 0), new(0.014f, 0.004f), new(0.023f, 0.02f), new(0.025f, 0.035f), new(0.018f, 0.056f),
        new(0.012f, 0.064f), new(0, 0.05f)], 18)
        .Bent(p => Stem(1) + p + (lean * p.Y * 6) + (p * 0.12f * MathF.Cos(3 * MathF.Atan2(p.Z, p.X)))));
    for (int k = 0; k < 2; k++)
    {
        Vector3 side = Around(0.024f, 0, (i * 0.382f) + 0.25f + (0.5f * k));
        Vector3 along = (0.4f * lean) + (1.5f * side);
        stems.Sheet(6, 4, (u, v) => Stem(0.15f) + (along * (u + (u * u))) + new Vector3(0, (0.3f * u) - (0.13f * u * u), 0)
            + (Vector3.Cross(Vector3.Normalize(along), Vector3.UnitY) * (v - 0.5f) * 0.06f * MathF.Sin(MathF.PI * ((0.96f * u) + 0.02f))));
    }
}

Save("tulip-leaves", stems);
Save("tulip-blossoms", blossoms);
Save("table", Lathe([new(0, 0), new(0.2f, 0), new(0.2f, 0), new(0.2f, 0.02f), new(0.1f, 0.05f), new(0.035f, 0.09f),
    new(0.03f, 0.2f), new(0.05f, 0.3f), new(0.045f, 0.36f), new(0.025f, 0.42f), new(0.03f, 0.56f), new(0.08f, 0.6f), new(0.08f, 0.6f),
    new(0.36f, 0.605f), new(0.36f, 0.605f), new(0.375f, 0.615f), new(0.36f, 0.63f), new(0.36f, 0.63f), new(0, 0.63f)], 64));

Save("../caustics/lens", Lens(0.05f, 0.236f));
Save("../caustics/water", Water(1.22f, 72));

void Save(string name, Mesh mesh) => mesh.Write(Path.Combine(folder, name + ".ply"));

static string Here([CallerFilePath] string path = "") => Path.GetDirectoryName(path)!;

// Rows of rhombs in turn: ruby and amber, cobalt and emerald.
static int PaneColour(int row, int column) => ((row & 1) * 2) + (column & 1);

static Vector2 Polar(float r, float t) => new(r * MathF.Sin(MathF.PI * t), -r * MathF.Cos(MathF.PI * t));

static Vector3 Around(float r, float y, float turn) => new(r * MathF.Cos(MathF.Tau * turn), y, r * MathF.Sin(MathF.Tau * turn));

// The town's ground at some distance from the shore: a quay, and a hill that becomes flatter towards its top.
static Vector3 Land(float x, float inland)
{
    float slope = 1 - MathF.Exp(-MathF.Pow(MathF.Max(inland - 9, 0) / 46, 1.25f));
    return new(x, 1.3f + (30 * slope * (0.78f + (0.22f * MathF.Sin((0.035f * x) + 1)))), (0.004f * x * x) - inland);
}

static float Lobes(Vector3 p) => MathF.Cos(5 * MathF.Atan2(p.Z, p.X));

static Vector3 Tilt(float degrees) => new(0, -MathF.Sin(degrees * MathF.PI / 180), MathF.Cos(degrees * MathF.PI / 180));

// Catmull and Rom's curve through the points, each with some numbers.
static IEnumerable<float[]> Smooth(float[][] points, int steps)
{
    for (int i = 0; i + 1 < points.Length; i++)
    {
        float[] a = points[Math.Max(i - 1, 0)], b = points[i], c = points[i + 1], d = points[Math.Min(i + 2, points.Length - 1)];
        for (int s = 0; s < steps + (i + 2 == points.Length ? 1 : 0); s++)
        {
            float t = (float)s / steps;
            yield return [.. b.Select((_, k) => 0.5f * ((2 * b[k]) + ((c[k] - a[k]) * t) + (((2 * a[k]) - (5 * b[k])
                + (4 * c[k]) - d[k]) * t * t) + (((3 * (b[k] - c[k])) + d[k] - a[k]) * t * t * t)))];
        }
    }
}

// A body of revolution: a curve through the points, which has an edge where a point stands twice.
static Mesh Lathe(Vector2[] profile, int around = 40)
{
    Mesh mesh = new();
    List<float[]> run = [];
    for (int i = 0; i < profile.Length; i++)
    {
        run.Add([profile[i].X, profile[i].Y]);
        if (i + 1 == profile.Length || profile[i] == profile[i + 1])
        {
            if (run.Count > 1)
            {
                mesh.Revolve([.. Smooth([.. run], run.Count == 2 ? 1 : 4).Select(p => new Vector2(MathF.Max(p[0], 0), p[1]))], around);
            }

            run = [];
        }
    }

    return mesh;
}

// A tube along a path, of a radius that varies.
static Mesh Swept(Func<float, Vector3> path, Func<float, float> radius, int along, int around)
{
    Mesh mesh = new();
    mesh.Tube([.. Enumerable.Range(0, along + 1).Select(i =>
    {
        float t = (float)i / along;
        Vector3 forward = Vector3.Normalize(path(t + 0.01f) - path(t - 0.01f));
        Vector3 u = Vector3.Normalize(Vector3.Cross(forward, MathF.Abs(forward.Y) > 0.7f ? Vector3.UnitX : Vector3.UnitY));
        return (path(t), u * radius(t), Vector3.Cross(forward, u) * radius(t));
    })], around);
    return mesh;
}

// A branch, and what grows out of it; the last ones bear leaves.
static void Grow(Mesh wood, Mesh leaves, Random random, Vector3 at, Vector3 forward, float length, float radius, int depth)
{
    float Any() => (2 * random.NextSingle()) - 1;
    Vector3 bend = new Vector3(Any(), Any() + 0.5f, Any()) * 0.22f;
    Vector3 Path(float t) => at + (length * t * (forward + (bend * t)));
    float taper = depth == 0 ? 0.7f : 0.35f;
    wood.Add(Swept(Path, t => radius * (1 - (taper * t)) * (depth == 6 ? 1 + (0.7f * MathF.Exp(-9 * t)) : 1), depth > 3 ? 5 : 2,
        depth > 3 ? 9 : depth > 1 ? 5 : 3));
    Vector3 end = Path(1);
    Vector3 on = Vector3.Normalize(forward + (2 * bend));
    for (int i = 0; depth <= 1 && i < 11; i++)
    {
        Vector3 normal = Vector3.Normalize(new Vector3(Any(), 1 + Any(), Any()));
        Vector3 u = Vector3.Normalize(Vector3.Cross(normal, new Vector3(Any(), Any(), Any())));
        leaves.Leaf(Path(random.NextSingle()) + (0.1f * new Vector3(Any(), Any(), Any())), u * 0.12f, Vector3.Cross(normal, u) * 0.05f,
            normal);
    }

    int children = depth == 0 ? 0 : depth > 4 ? 3 : random.Next(2, 4);
    float turn = random.NextSingle();
    for (int i = 0; i < children; i++)
    {
        Vector3 side = Vector3.Normalize(Vector3.Cross(on, Around(1, 0.1f, turn + ((float)i / children))));
        float spread = 0.45f + (0.35f * random.NextSingle());
        Grow(wood, leaves, random, end, Vector3.Normalize(on + (side * spread) + (Vector3.UnitY * 0.05f)),
            length * (0.68f + (0.18f * random.NextSingle())), radius * 0.6f, depth - 1);
    }
}

// A lens of two caps of spheres, which meet in a sharp edge around the y axis.
static Mesh Lens(float aperture, float radius)
{
    const int Rings = 20, Sides = 80;
    Mesh mesh = new();
    float middle = MathF.Sqrt((radius * radius) - (aperture * aperture));
    foreach (float side in new[] { 1f, -1f })
    {
        mesh.Sheet(Rings, Sides, (u, v) =>
        {
            // The pole is a ring that is too small to be seen.
            (float sin, float cos) = MathF.SinCos(-side * MathF.Tau * (v % 1));
            float r = aperture * MathF.Max(u, 1e-4f);
            Vector3 p = new(r * cos, MathF.Sqrt((radius * radius) - (r * r)), r * sin);
            return (new Vector3(p.X, side * (p.Y - middle), p.Z), new Vector3(p.X, side * p.Y, p.Z));
        });
    }

    return mesh;
}

// The surface of a pool, whose waves run in all directions, and below it straight sides and a level bottom, to be hidden within walls
// and floor.
static Mesh Water(float half, int cells)
{
    const float Depth = 0.92f;
    Random random = new(11);
    (Vector2 Wave, float Height, float Phase)[] waves = [.. Enumerable.Range(0, 9).Select(i =>
    {
        (float sin, float cos) = MathF.SinCos(MathF.Tau * (i + (0.7f * random.NextSingle())) / 9);
        float perMetre = MathF.Tau / (0.28f + (0.08f * i));
        return (perMetre * new Vector2(cos, sin), 1.1f / (perMetre * perMetre), MathF.Tau * random.NextSingle());
    })];
    Mesh mesh = new();
    mesh.Sheet(cells, cells, (u, v) =>
    {
        Vector2 at = new(half * ((2 * u) - 1), half * ((2 * v) - 1));
        float height = waves.Sum(w => w.Height * MathF.Sin(Vector2.Dot(w.Wave, at) + w.Phase));
        float x = waves.Sum(w => w.Height * w.Wave.X * MathF.Cos(Vector2.Dot(w.Wave, at) + w.Phase));
        float z = waves.Sum(w => w.Height * w.Wave.Y * MathF.Cos(Vector2.Dot(w.Wave, at) + w.Phase));
        return (new Vector3(at.X, height, at.Y), new Vector3(-x, 1, -z));
    });
    Vector3 Surface(float u, float v) => mesh.Corner(((int)MathF.Round(u * cells) * (cells + 1)) + (int)MathF.Round(v * cells));
    Vector3 Below(Vector3 p, float t) => p with { Y = p.Y + (t * (-Depth - p.Y)) };
    mesh.Sheet(cells, 1, (u, v) => (Below(Surface(u, 1), v), Vector3.UnitZ));
    mesh.Sheet(cells, 1, (u, v) => (Below(Surface(1 - u, 0), v), -Vector3.UnitZ));
    mesh.Sheet(cells, 1, (u, v) => (Below(Surface(1, 1 - u), v), Vector3.UnitX));
    mesh.Sheet(cells, 1, (u, v) => (Below(Surface(0, u), v), -Vector3.UnitX));
    mesh.Sheet(1, 1, (u, v) => (new Vector3(half * ((2 * u) - 1), -Depth, half * (1 - (2 * v))), -Vector3.UnitY));
    return mesh;
}

/// <summary>Triangles with a normal at each corner.</summary>
internal sealed class Mesh
{
    private readonly List<(Vector3 Position, Vector3 Normal)> _corners = [];
    private readonly List<(int A, int B, int C)> _triangles = [];

    public void Add(Mesh other)
    {
        int first = _corners.Count;
        _corners.AddRange(other._corners);
        _triangles.AddRange(other._triangles.Select(t => (t.A + first, t.B + first, t.C + first)));
    }

    /// <summary>Moves every point, and turns the normals accordingly.</summary>
    public Mesh Bent(Func<Vector3, Vector3> bend)
    {
        const float Step = 1e-3f;
        for (int i = 0; i < _corners.Count; i++)
        {
            (Vector3 p, Vector3 n) = _corners[i];
            Vector3 u = Vector3.Normalize(Vector3.Cross(n, MathF.Abs(n.Y) > 0.7f * n.Length() ? Vector3.UnitX : Vector3.UnitY));
            Vector3 v = Vector3.Normalize(Vector3.Cross(n, u));
            Vector3 Along(Vector3 t) => bend(p + (Step * t)) - bend(p - (Step * t));
            _corners[i] = (bend(p), Vector3.Cross(Along(u), Along(v)));
        }

        return this;
    }

    /// <summary>A surface over the unit square; seen from its front, u grows downwards and v to the right.</summary>
    public void Sheet(int rows, int columns, Func<float, float, Vector3> point) => Grid(rows + 1, columns + 1, (i, j) =>
    {
        const float Step = 1e-3f;
        (float u, float v) = ((float)i / rows, (float)j / columns);
        return (point(u, v), Vector3.Cross(point(u + Step, v) - point(u - Step, v), point(u, v + Step) - point(u, v - Step)));
    }, isClosed: false);

    /// <summary>As the other, with normals, which also say which side of a triangle is its front.</summary>
    public void Sheet(int rows, int columns, Func<float, float, (Vector3 Position, Vector3 Normal)> corner)
    {
        int first = _triangles.Count;
        Grid(rows + 1, columns + 1, (i, j) => corner((float)i / rows, (float)j / columns), isClosed: false, flat: 0);
        for (int i = first; i < _triangles.Count; i++)
        {
            (int a, int b, int c) = _triangles[i];
            Vector3 front = Vector3.Cross(Corner(b) - Corner(a), Corner(c) - Corner(a));
            _triangles[i] = Vector3.Dot(front, _corners[a].Normal) > 0 ? (a, b, c) : (a, c, b);
        }
    }

    public Vector3 Corner(int i) => _corners[i].Position;

    public void Revolve(Vector2[] curve, int around) => Grid(curve.Length, around, (i, j) =>
    {
        Vector2 along = curve[Math.Min(i + 1, curve.Length - 1)] - curve[Math.Max(i - 1, 0)];
        (float sin, float cos) = MathF.SinCos(MathF.Tau * j / around);
        return (new(curve[i].X * cos, curve[i].Y, curve[i].X * sin), new(along.Y * cos, -along.X, along.Y * sin));
    });

    public void Tube((Vector3 Middle, Vector3 U, Vector3 V)[] rings, int around = 24)
    {
        Grid(rings.Length, around, (i, j) =>
        {
            (float sin, float cos) = MathF.SinCos(-MathF.Tau * j / around);
            (Vector3 middle, Vector3 u, Vector3 v) = rings[i];
            return (middle + (u * cos) + (v * sin), (u * cos / u.LengthSquared()) + (v * sin / v.LengthSquared()));
        });
    }

    public void Ball(Vector3 middle, float radius, int steps = 10) => Grid(steps + 1, 2 * steps, (i, j) =>
    {
        float t = MathF.PI * i / steps;
        (float sin, float cos) = MathF.SinCos(MathF.PI * j / steps);
        Vector3 n = new(MathF.Sin(t) * cos, -MathF.Cos(t), MathF.Sin(t) * sin);
        return (middle + (radius * n), n);
    });

    public void Box(Vector3 a, Vector3 b)
    {
        Vector3 size = b - a;
        (Vector3 x, Vector3 y, Vector3 z) = (new(size.X, 0, 0), new(0, size.Y, 0), new(0, 0, size.Z));
        Quad(a + z, x, y);
        Quad(a + x, -x, y);
        Quad(a, z, y);
        Quad(b - y, -z, y);
        Quad(a + y + z, x, -z);
        Quad(a, x, z);
    }

    /// <summary>A part of a wall in a ring, with its top and its ends.</summary>
    public void Wedge(float inner, float outer, float bottom, float top, float from, float to)
    {
        const int Steps = 6;
        for (int i = 0; i < Steps; i++)
        {
            Vector3 a = Direction(from + ((to - from) * i / Steps));
            Vector3 b = Direction(from + ((to - from) * (i + 1) / Steps));
            Vector3 up = new(0, top - bottom, 0);
            Vector3 foot = new(0, bottom, 0);
            Quad(foot + (b * outer), (a - b) * outer, up);
            Quad(foot + (a * inner), (b - a) * inner, up);
            Quad(foot + up + (b * outer), (a - b) * outer, b * (inner - outer));
        }

        foreach ((float angle, float sign) in new[] { (from, 1f), (to, -1f) })
        {
            Vector3 d = Direction(angle);
            Quad((d * (sign > 0 ? outer : inner)) + new Vector3(0, bottom, 0), d * sign * (inner - outer), new(0, top - bottom, 0));
        }
    }

    public void Pane(Vector3 a, Vector3 b, Vector3 c) => Triangle(a, b, c);

    public void Rod(Vector3 from, Vector3 to, float radius)
    {
        Vector3 u = Vector3.Normalize(Vector3.Cross(to - from, Vector3.UnitY)) * radius;
        Vector3 v = Vector3.Normalize(Vector3.Cross(to - from, u)) * radius;
        Tube([(from, u, v), (to, u, v)], 6);
    }

    public void Leaf(Vector3 at, Vector3 u, Vector3 v, Vector3 normal)
    {
        int first = _corners.Count;
        _corners.AddRange([(at, normal), (at + (u * 0.5f) + v, normal), (at + u, normal), (at + (u * 0.5f) - v, normal)]);
        _triangles.AddRange([(first, first + 1, first + 2), (first, first + 2, first + 3)]);
    }

    public void Write(string path)
    {
        using BinaryWriter writer = new(File.Create(path));
        writer.Write($"""
            ply
            format binary_little_endian 1.0
            element vertex {_corners.Count}
            property float x
            property float y
            property float z
            property float nx
            property float ny
            property float nz
            element face {_triangles.Count}
            property list uchar int vertex_indices
            end_header

            """.ReplaceLineEndings("\n").ToCharArray());
        foreach ((Vector3 p, Vector3 normal) in _corners)
        {
            Vector3 n = normal == default ? Vector3.UnitY : Vector3.Normalize(normal);
            foreach (float x in new[] { p.X, p.Y, p.Z, n.X, n.Y, n.Z })
            {
                writer.Write(x);
            }
        }

        foreach ((int a, int b, int c) in _triangles)
        {
            writer.Write((byte)3);
            writer.Write(a);
            writer.Write(b);
            writer.Write(c);
        }

        Console.WriteLine($"{Path.GetFileName(path)}: {_triangles.Count} triangles, {writer.BaseStream.Length / 1000} kB");
    }

    private static Vector3 Direction(float angle) => new(MathF.Cos(angle), 0, MathF.Sin(angle));

    // Rows of corners, each of which may be closed to a ring; triangles without area, at the poles, are left out.
    private void Grid(int rows, int around, Func<int, int, (Vector3 Position, Vector3 Normal)> corner, bool isClosed = true,
        float flat = 1e-14f)
    {
        int first = _corners.Count;
        for (int i = 0; i < rows; i++)
        {
            for (int j = 0; j < around; j++)
            {
                _corners.Add(corner(i, j));
            }
        }

        for (int i = 0; i + 1 < rows; i++)
        {
            for (int j = 0; j < (isClosed ? around : around - 1); j++)
            {
                (int a, int b) = (first + (i * around) + j, first + (i * around) + ((j + 1) % around));
                AddUnlessFlat(a, a + around, b + around, flat);
                AddUnlessFlat(a, b + around, b, flat);
            }
        }
    }

    private void AddUnlessFlat(int a, int b, int c, float flat)
    {
        Vector3 p = _corners[a].Position;
        if (Vector3.Cross(_corners[b].Position - p, _corners[c].Position - p).LengthSquared() > flat)
        {
            _triangles.Add((a, b, c));
        }
    }

    private void Quad(Vector3 corner, Vector3 u, Vector3 v)
    {
        Triangle(corner, corner + u, corner + u + v);
        Triangle(corner, corner + u + v, corner + v);
    }

    private void Triangle(Vector3 a, Vector3 b, Vector3 c)
    {
        Vector3 normal = Vector3.Cross(b - a, c - a);
        int first = _corners.Count;
        _corners.AddRange([(a, normal), (b, normal), (c, normal)]);
        _triangles.Add((first, first + 1, first + 2));
    }
}
