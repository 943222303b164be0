using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;
using RayTracer.Textures;
using Plane = RayTracer.Shapes.PlaneDescription;

namespace RayTracer.RenderTests;

/// <summary>
/// Scenes that physics says look the same: another scale, place, attitude or order of things. The world is changed exactly, in powers of
/// two and quarter turns, so that only the program's treatment of it differs.
/// Covers `Transform`, `SceneAssembler`, `SphereBatch` and `FlatBatch`.
/// </summary>
[Trait("Category", "Thorough")]
public class EquivalentScenesTests
{
    private static readonly int s_seeds = TestSettings.Scale(32, 128);
    private static readonly Lazy<ImageSamples> s_reference = new(() => Render(World.Identity, firstSeed: 1));

    [Theory]
    [InlineData(-20)]
    [InlineData(-3)]
    [InlineData(1)]
    [InlineData(20)]
    public void A_world_scaled_by_a_power_of_two_gives_the_same_bits(int exponent)
    {
        // All lengths are multiplied exactly, and with them every intermediate result: only fixed lengths in the program would show.
        string expected = Film(World.Identity, seed: 1).ComputeHash();
        Assert.Equal(expected, Film(World.Identity with { Scale = MathF.ScaleB(1, exponent) }, seed: 1).ComputeHash());
    }

    [Fact]
    public void A_world_in_other_units_looks_the_same() => AssertSame("scaled by 1/0.3048", World.Identity with { Scale = 1 / 0.3048f });

    [Fact]
    public void A_world_elsewhere_looks_the_same() => AssertSame("moved", World.Identity with { Shift = new(16, -8, 64) });

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void A_world_turned_by_a_right_angle_looks_the_same(int axis) => AssertSame($"turned about axis {axis}", World.Identity with { Axis = axis });

    [Fact]
    public void A_mirrored_world_looks_mirrored() => AssertSame("mirrored", World.Identity with { IsMirrored = true });

    [Fact]
    public void The_order_of_shapes_does_not_matter() => AssertSame("listed backwards", World.Identity with { IsBackwards = true });

    private static void AssertSame(string what, World world)
    {
        BlockTest test = BlockTest.Compare(Render(world, firstSeed: 1001), s_reference.Value);
        ErrorBudget.Geometry.Check(test.P, $"the world {what}: {test}");
    }

    private static ImageSamples Render(World world, long firstSeed)
    {
        ImageSamples images = new(World.Width, World.Height);
        for (int i = 0; i < s_seeds; i++)
        {
            Film film = Film(world, (uint)(firstSeed + i + (TestSettings.Seed * 1_000_000L)));
            images.Add(world.IsMirrored ? new Mirrored(film) : film);
        }

        return images;
    }

    private static Film Film(World world, long seed)
    {
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        Scene? scene = builder.Build(world.Describe(seed));
        Assert.Empty(builder.Complaints);
        return new RTracer(scene!).Render().Film;
    }

    /// <summary>An image seen from behind.</summary>
    private sealed class Mirrored(IImageRows image) : IImageRows
    {
        public int Width => image.Width;

        public int Height => image.Height;

        public void ReadRow(int y, Span<float> rgb)
        {
            image.ReadRow(y, rgb);
            rgb.Reverse();
            for (int x = 0; x < Width; x++)
            {
                rgb.Slice(3 * x, 3).Reverse();
            }
        }
    }

    /// <summary>A scene of all materials and shapes, placed into the world in some way.</summary>
    private sealed record World(float Scale, Vector3 Shift, int Axis, bool IsMirrored, bool IsBackwards)
    {
        public const int Width = 48;
        public const int Height = 32;

        public static readonly World Identity = new(1, Vector3.Zero, -1, IsMirrored: false, IsBackwards: false);

        public SceneDescription Describe(long seed)
        {
            ShapeDescription[] shapes = [.. Shapes()];
            return new()
            {
                Camera = new()
                {
                    Position = At(0, 1.5f, 5),
                    LookAt = At(0, 0.75f, 0),
                    Up = Turned(new(0, 1, 0)),
                    Lens = new() { ApertureRadius = 0.0625f * Scale, FocusDistance = 5 * Scale },
                },
                Render = new() { Integrator = Integrator.Report, Width = Width, Height = Height, SamplesPerPixel = 16, MaxSpecularDepth = 8, Seed = seed },
                Background = new(0.2f, 0.3f, 0.5f),
                Shapes = IsBackwards ? [.. shapes.Reverse()] : shapes,
            };
        }

        private IEnumerable<ShapeDescription> Shapes()
        {
            MaterialDescription metal = new PhongMetalMaterialDescription { Color = Solid(0.9f, 0.8f, 0.7f), Exponent = 300 };
            MaterialDescription grey = new DiffuseMaterialDescription { Color = Solid(0.5f, 0.6f, 0.4f) };
            MaterialDescription glass = new DielectricMaterialDescription { RefractiveIndex = 1.5f, Extinction = new Rgb(1, 0.25f, 0.5f) * (1 / Scale) };
            yield return Ball(-1.25f, 0.625f, 0, 0.625f, glass);
            yield return Ball(0.25f, 0.625f, -0.5f, 0.625f, metal);
            yield return Ball(1.5f, 0.5f, 0.5f, 0.5f, new DiffuseSpecularMaterialDescription { Diffuse = grey, Specular = metal });
            yield return new Plane { Point = At(0, 0, 0), Normal = Turned(new(0, 1, 0)), Material = grey };
            yield return Square(At(0, 1, -2), new(0, 0, 1), 2, grey);
            yield return Corners(new(-2, 0, -1), new(-1, 0, -1.5f), new(-1.5f, 1.5f, -1.25f), metal);
            yield return Corners(new(2, 0, -1), new(2.5f, 1, -1), new(1.5f, 1, -1.5f), glass);
            yield return Ball(1, 3, 2, 0.25f, Lamp(12, 1));
            yield return Square(At(-2, 3, 1), new(0, -1, 0), 1, Lamp(6, 0));
            yield return Corners(new(2, 3, -1), new(1, 3, -1), new(2, 3, 0), Lamp(8, 0));
        }

        private static SolidTextureDescription Solid(float r, float g, float b) => new() { Color = new(r, g, b) };

        private static LuminaireMaterialDescription Lamp(float multiplier, float exponent) => new() { Multiplier = multiplier, Exponent = exponent };

        private SphereDescription Ball(float x, float y, float z, float radius, MaterialDescription material) =>
            new() { Center = At(x, y, z), Radius = radius * Scale, Material = material };

        private Plane Square(Vector3 point, Vector3 normal, float side, MaterialDescription material) =>
            new() { Point = point, Normal = Turned(normal), Size = new Vector2(side * Scale), Material = material };

        // A mirror makes clockwise of counter-clockwise.
        private TriangleDescription Corners(Vector3 a, Vector3 b, Vector3 c, MaterialDescription material) => new()
        {
            A = At(a.X, a.Y, a.Z),
            B = IsMirrored ? At(c.X, c.Y, c.Z) : At(b.X, b.Y, b.Z),
            C = IsMirrored ? At(b.X, b.Y, b.Z) : At(c.X, c.Y, c.Z),
            Material = material,
        };

        private Vector3 At(float x, float y, float z) => (Turned(new(x, y, z)) * Scale) + Shift;

        private Vector3 Turned(Vector3 v)
        {
            v = IsMirrored ? v with { X = -v.X } : v;
            return Axis switch
            {
                0 => new(v.X, -v.Z, v.Y),
                1 => new(v.Z, v.Y, -v.X),
                2 => new(-v.Y, v.X, v.Z),
                _ => v,
            };
        }
    }
}
