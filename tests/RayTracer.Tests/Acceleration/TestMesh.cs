using System.Numerics;

namespace RayTracer.Tests.Acceleration;

/// <summary>Triangles to build trees over.</summary>
internal sealed record TestMesh(Vector3[] Positions, int[] Indices)
{
    public int Count => Indices.Length / 3;

    public Vector3 Corner(int triangle, int corner) => Positions[Indices[(3 * triangle) + corner]];

    public static TestMesh Named(string name, int seed) => name switch
    {
        "empty" => new([], []),
        "one" => Soup(1, 1f, seed),
        "nine" => Soup(9, 1f, seed),
        "soup" => Soup(2000, 0.2f, seed),
        "dense soup" => Soup(300, 2f, seed),
        "terrain" => Terrain(40, seed),
        "needles" => Needles(1000, seed),
        "equal" => Equal(500),
        "layers" => Layers(300),
        "huge" => Soup(500, 0.2f, seed).Scaled(1e15f),
        "tiny" => Soup(500, 0.2f, seed).Scaled(1e-12f),
        "far away" => Soup(500, 0.2f, seed).Moved(new(3000f, -5000f, 100f)),
        "flat" => Terrain(20, seed).Flattened(),
        "scales" => Scales(400, seed),
        "faulty" => Faulty(seed),
        _ => throw new ArgumentException(name, nameof(name)),
    };

    public static TestMesh Soup(int count, float size, int seed)
    {
        Random random = new(seed);
        Vector3[] positions = new Vector3[3 * count];
        for (int i = 0; i < count; i++)
        {
            Vector3 place = Cube(random);
            for (int corner = 0; corner < 3; corner++)
            {
                positions[(3 * i) + corner] = place + (Cube(random) * size);
            }
        }

        return new(positions, [.. Enumerable.Range(0, 3 * count)]);
    }

    public static TestMesh Terrain(int edge, int seed)
    {
        Random random = new(seed);
        Vector3[] positions = new Vector3[(edge + 1) * (edge + 1)];
        for (int i = 0; i < positions.Length; i++)
        {
            positions[i] = new((2f * (i % (edge + 1)) / edge) - 1f, random.NextSingle() * 0.1f, (2f * (i / (edge + 1)) / edge) - 1f);
        }

        List<int> indices = [];
        for (int i = 0; i < edge * edge; i++)
        {
            int corner = (i / edge * (edge + 1)) + (i % edge);
            indices.AddRange([corner, corner + 1, corner + edge + 1, corner + 1, corner + edge + 2, corner + edge + 1]);
        }

        return new(positions, [.. indices]);
    }

    /// <summary>A closed surface: a ball whose corners are moved in and out.</summary>
    public static TestMesh Ball(int rings, int seed)
    {
        Random random = new(seed);
        int segments = 2 * rings;
        List<Vector3> positions = [new(0f, 1f, 0f), new(0f, -1f, 0f)];
        for (int ring = 1; ring < rings; ring++)
        {
            for (int segment = 0; segment < segments; segment++)
            {
                double polar = Math.PI * ring / rings;
                double azimuth = 2 * Math.PI * segment / segments;
                float radius = 0.7f + (0.5f * random.NextSingle());
                positions.Add(new Vector3((float)(Math.Sin(polar) * Math.Cos(azimuth)), (float)Math.Cos(polar), (float)(Math.Sin(polar) * Math.Sin(azimuth))) * radius);
            }
        }

        int Corner(int ring, int segment) => ring == 0 ? 0 : ring == rings ? 1 : 2 + ((ring - 1) * segments) + (segment % segments);
        List<int> indices = [];
        for (int ring = 0; ring < rings; ring++)
        {
            for (int segment = 0; segment < segments; segment++)
            {
                if (ring > 0)
                {
                    indices.AddRange([Corner(ring, segment), Corner(ring, segment + 1), Corner(ring + 1, segment)]);
                }

                if (ring < rings - 1)
                {
                    indices.AddRange([Corner(ring, segment + 1), Corner(ring + 1, segment + 1), Corner(ring + 1, segment)]);
                }
            }
        }

        return new([.. positions], [.. indices]);
    }

    public TestMesh Scaled(float factor) => this with { Positions = [.. Positions.Select(p => p * factor)] };

    public TestMesh Moved(Vector3 by) => this with { Positions = [.. Positions.Select(p => p + by)] };

    private static TestMesh Needles(int count, int seed)
    {
        Random random = new(seed);
        TestMesh soup = Soup(count, 1f, seed);
        for (int i = 0; i < count; i++)
        {
            // From blunt to needles that are only a rounding wide.
            float width = MathF.Pow(10f, -8f * random.NextSingle());
            soup.Positions[(3 * i) + 2] = Vector3.Lerp(soup.Positions[3 * i], soup.Positions[(3 * i) + 1], random.NextSingle()) + (Cube(random) * width);
        }

        return soup;
    }

    private static TestMesh Equal(int count) => new(
        [new(-1f, -1f, 0f), new(1f, -1f, 0.3f), new(0f, 1f, 0.1f)],
        [.. Enumerable.Range(0, 3 * count).Select(i => i % 3)]);

    /// <summary>Pairs of triangles over the same place in many numbers, in no order.</summary>
    private static TestMesh Layers(int count)
    {
        List<Vector3> positions = [];
        for (int i = 0; i < count; i++)
        {
            float z = i * 7 % 10 / 10f;
            positions.AddRange([new(-1f, -1f, z), new(1f, -1f, z), new(-1f, 1f, z), new(1f, 1f, z), new(-1f, 1f, z), new(1f, -1f, z)]);
        }

        return new([.. positions], [.. Enumerable.Range(0, positions.Count)]);
    }

    private static TestMesh Scales(int count, int seed)
    {
        Random random = new(seed);
        TestMesh soup = Soup(count, 1f, seed);
        for (int i = 0; i < soup.Positions.Length; i++)
        {
            soup.Positions[i] *= MathF.Pow(2f, -(i / 3) * 0.1f);
        }

        return soup;
    }

    private static TestMesh Faulty(int seed)
    {
        TestMesh soup = Soup(400, 0.3f, seed);
        soup.Positions[3].X = float.NaN;
        soup.Positions[7].Y = float.PositiveInfinity;
        soup.Positions[11].Z = -3e38f;
        soup.Positions[13] = soup.Positions[12];
        soup.Positions[17] = soup.Positions[16] = soup.Positions[15];
        (soup.Positions[18], soup.Positions[19], soup.Positions[20]) = (new(0f), new(0.25f), new(0.5f));
        soup.Indices[21] = -1;
        soup.Indices[25] = int.MaxValue;
        soup.Indices[29] = soup.Positions.Length;
        return soup;
    }

    private TestMesh Flattened() => this with { Positions = [.. Positions.Select(p => p with { Y = 0.25f })] };

    private static Vector3 Cube(Random random) => new((2f * random.NextSingle()) - 1f, (2f * random.NextSingle()) - 1f, (2f * random.NextSingle()) - 1f);
}
