using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;
using RayTracer.Testing;
using RayTracer.Tests.Shapes;

namespace RayTracer.Tests.Acceleration;

/// <summary>The tree over shapes of all kinds against the plain loop.</summary>
[Trait("Category", "Thorough")]
public unsafe class ShapeTreeTests
{
    private const int Nothing = 1_000_000;
    private const int Kinds = 14;
    private readonly Random _random = new(TestSettings.Seed);

    [Theory]
    [InlineData(0f)]
    [InlineData(30f)]
    public void Nearest_hits_are_the_same_to_the_bit_with_and_without_a_tree(float away)
    {
        (PrimitiveList loop, PrimitiveList tree) = Lists(Mixed(500, away));
        int hits = 0;
        for (int i = 0; i < TestSettings.Scale(20_000, 1_000_000) / FloatW.Count; i++)
        {
            Rays(away, out Vec3W origin, out Vec3W direction);
            loop.ClosestHit(origin, direction, out FloatW distance, out UIntW primitive);
            tree.ClosestHit(origin, direction, out FloatW otherDistance, out UIntW otherPrimitive);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Assert.Equal(primitive[lane], otherPrimitive[lane]);
                Assert.Equal(BitConverter.SingleToInt32Bits(distance[lane]), BitConverter.SingleToInt32Bits(otherDistance[lane]));
                hits += primitive[lane] != Nothing ? 1 : 0;
            }
        }

        Assert.NotEqual(0, hits);
    }

    [Fact]
    public void Occlusion_is_the_same_with_and_without_a_tree_and_leaves_out_the_same_primitive()
    {
        (PrimitiveList loop, PrimitiveList tree) = Lists(Mixed(100, away: 0));
        (int blocked, int freed) = (0, 0);
        for (int i = 0; i < TestSettings.Scale(20_000, 1_000_000) / FloatW.Count; i++)
        {
            Rays(away: 0, out Vec3W origin, out Vec3W direction);
            loop.ClosestHit(origin, direction, out FloatW distance, out UIntW primitive);
            FloatW end = (distance < 1e3f).Select(distance * (0.5f + _random.NextSingle()), 5f);
            MaskW wanted = MaskW.First(_random.Next(FloatW.Count + 1));
            MaskW all = wanted;
            loop.Occlude(origin, direction, end, -1, ref all);
            foreach (int skip in new[] { -1, (int)primitive[0] })
            {
                (MaskW expected, MaskW free) = (wanted, wanted);
                loop.Occlude(origin, direction, end, skip, ref expected);
                tree.Occlude(origin, direction, end, skip, ref free);
                Assert.Equal(expected.Bits, free.Bits);
                blocked += expected.Bits != wanted.Bits ? 1 : 0;
                freed += expected.Bits != all.Bits ? 1 : 0;
            }
        }

        Assert.NotEqual(0, blocked);
        Assert.NotEqual(0, freed);
    }

    [Fact]
    public void Of_equally_near_shapes_the_lowest_number_is_hit_and_nothing_at_the_limit()
    {
        Material material = new RandomShape("sphere", 1, 1, 0).Shape.Material;
        Shape[] shapes = [.. Enumerable.Range(0, 40).Select(i => new Sphere(material, "", new(i % 4 * 3, 0, 0), 1))];
        (_, PrimitiveList tree) = Lists([.. shapes, new RayTracer.Shapes.Plane(material, "", new(0, 1, 0), Vector3.UnitY, null)]);
        for (int place = 0; place < 4; place++)
        {
            Vector3 above = new(place * 3, 5, 0);
            tree.ClosestHit(above, -Vector3.UnitY, out FloatW distance, out UIntW primitive);
            Assert.Equal((4f, (uint)place), (distance[0], primitive[0]));

            (FloatW limit, UIntW none) = (4f, uint.MaxValue);
            tree.Shorten(above, -Vector3.UnitY, ref limit, ref none);
            Assert.Equal((4f, uint.MaxValue), (limit[0], none[0]));
        }
    }

    [Fact]
    public void Films_are_the_same_to_the_bit_with_and_without_a_tree()
    {
        SceneDescription description = Scene(500);
        string[] hashes = [.. new int?[] { null, 0, int.MaxValue }.Select(loop =>
        {
            SceneBuilder builder = new((_, _) => throw new NotSupportedException()) { LargestLoop = loop };
            return new RTracer(builder.Build(description)!).Render().Film.ComputeHash();
        })];
        Assert.Equal(hashes[0], hashes[1]);
        Assert.Equal(hashes[0], hashes[2]);
    }

    private static (PrimitiveList Loop, PrimitiveList Tree) Lists(Shape[] shapes)
    {
        Shape[] sorted = [.. shapes.GroupBy(s => s.GetType()).SelectMany(kind => kind)];
        ShapeBatch[] batches = [.. sorted.GroupBy(s => s.GetType()).Select(kind => kind.First().CreateBatch([.. kind]))];
        int first = 0;
        foreach (ShapeBatch batch in batches)
        {
            batch.FirstPrimitive = first;
            first += batch.Count;
        }

        return (new(sorted, batches, Nothing, int.MaxValue), new(sorted, batches, Nothing, 0));
    }

    // Shapes of all kinds and sizes, around the origin or far from it; one of them is a plane without end.
    private Shape[] Mixed(int count, float away)
    {
        Assert.Equal(Kinds, RandomShape.Kinds.Length);
        Shape[] shapes = new Shape[count];
        for (int i = 0; i < count; i++)
        {
            string kind = RandomShape.Kinds[i % Kinds];
            kind = kind == "plane" && i != 2 ? "sphere" : kind;
            float scale = MathF.Pow(10, -2 * _random.NextSingle()) * 0.3f;
            shapes[i] = new RandomShape(kind, _random.Next(), scale, (1 + away) / scale).Shape;
        }

        return shapes;
    }

    private void Rays(float away, out Vec3W origin, out Vec3W direction)
    {
        float* numbers = stackalloc float[6 * FloatW.Count];
        float size = 1 + away;
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Vector3 from = Cube() * (2 * size);
            Vector3 to = _random.Next(8) == 0 ? from + new Vector3(_random.Next(2), 0, _random.Next(3) - 1.5f) : Cube() * size;
            Vector3 unit = Vector3.Normalize(to - from);
            for (int axis = 0; axis < 3; axis++)
            {
                numbers[(axis * FloatW.Count) + lane] = from[axis];
                numbers[((3 + axis) * FloatW.Count) + lane] = unit[axis];
            }
        }

        origin = Load(numbers);
        direction = Load(numbers + (3 * FloatW.Count));
    }

    private static Vec3W Load(float* from) => new(FloatW.Load(from), FloatW.Load(from + FloatW.Count), FloatW.Load(from + (2 * FloatW.Count)));

    private Vector3 Cube() => new((2 * _random.NextSingle()) - 1, (2 * _random.NextSingle()) - 1, (2 * _random.NextSingle()) - 1);

    private SceneDescription Scene(int count)
    {
        MaterialDescription glass = new DielectricMaterialDescription();
        List<ShapeDescription> shapes = [new PlaneDescription { Point = new(0, -1, 0) }];
        for (int i = 0; i < count; i++)
        {
            Vector3 center = Cube();
            MaterialDescription material = i % 7 == 0 ? glass : ShapeDescription.DefaultMaterial;
            shapes.Add((i % 6) switch
            {
                0 => new BoxDescription { A = center, B = center + new Vector3(0.1f), Material = material },
                1 => new DiskDescription { Center = center, Normal = Cube(), Radius = 0.1f, Material = material },
                2 => new TriangleDescription { A = center, B = center + (0.2f * Cube()), C = center + (0.2f * Cube()), Material = material },
                3 => new TorusDescription { Center = center, Axis = Cube(), Radius = 0.08f, TubeRadius = 0.03f, Material = material },
                4 => new CylinderDescription { Bottom = center, Top = center + (0.1f * Cube()), Radius = 0.04f, Material = material },
                _ => new SphereDescription { Center = center, Radius = 0.06f, Material = material },
            });
        }

        return new()
        {
            Camera = new() { Position = new(1, 1, 4), LookAt = Vector3.Zero },
            Render = new() { Width = 40, Height = 40, SamplesPerPixel = 4 },
            Background = new(0.4f, 0.5f, 0.6f),
            Shapes = shapes,
            Lights = [Lamp(new SphereDescription { Center = new(2, 4, 2), Radius = 0.5f }), Lamp(new DiskDescription { Center = new(-0.5f, 1, 1), Normal = new(0, -1, 0), Radius = 0.3f })],
        };
    }

    private static ShapeDescription Lamp(ShapeDescription shape) => shape with { Material = new LuminaireMaterialDescription { Multiplier = 10 } };
}
