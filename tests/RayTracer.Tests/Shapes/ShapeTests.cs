using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;
using Plane = RayTracer.Shapes.Plane;

namespace RayTracer.Tests.Shapes;

public class ShapeTests
{
    private static readonly Material s_material = new DiffuseMaterial(new SolidTexture(Rgb.White));

    public static TheoryData<string> Kinds() =>
        ["sphere", "surface sphere", "rectangle", "triangle", "disk", "parallelogram", "box", "turned box", "cylinder", "cone", "frustum", "torus"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_ray_to_a_sampled_point_meets_the_shape_there(string kind)
    {
        Shape shape = Make(kind);
        ShapeBatch batch = shape.CreateBatch([shape]);
        int samples = 0;
        int hidden = 0;
        foreach (Vector3 place in new Vector3[] { new(0.5f, 3, 1), new(3, -2.5f, 0.3f) })
        {
            ForEachSample(
                shape,
                (from, sample, _) =>
                {
                    FloatW distance = float.PositiveInfinity;
                    UIntW primitive = 99u;
                    batch.ClosestHit(from, sample.Direction, ref distance, ref primitive);
                    Assert.Equal(0u, primitive[0]);
                    if (!IsSeen(batch, from, sample))
                    {
                        Assert.InRange(distance[0], 0, sample.Distance[0] * (1 - 1e-3f));
                        hidden++;
                        return;
                    }

                    Assert.InRange(distance[0], sample.Distance[0] * (1 - 2e-3f), sample.Distance[0] * (1 + 2e-3f));
                },
                ref samples,
                place);
        }

        // From the side, a torus hides its own far side.
        Assert.Equal(shape is Torus, hidden > 100);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void The_lines_that_show_a_shape_fill_its_bounds(string kind)
    {
        Bounds bounds = Make(kind).Bounds;
        Bounds drawn = Make(kind).Wires(default, 1).SelectMany(l => l).Aggregate(Bounds.Empty, (all, p) => all.Union(new(p, p)));
        float size = (bounds.Maximum - bounds.Minimum).Length();
        Assert.True((bounds.Minimum - drawn.Minimum).Length() + (bounds.Maximum - drawn.Maximum).Length() < 0.1f * size, $"the lines of the {kind} fill {drawn}, but it is within {bounds}");
        Assert.All([bounds.Minimum - drawn.Minimum, drawn.Maximum - bounds.Maximum], beyond => Assert.True(Vector3.Max(beyond, default).Length() < 1e-5f * size, $"the lines of the {kind} leave its bounds"));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Sampled_directions_integrate_to_the_solid_angle(string kind)
    {
        // The mean of 1/pdf is the solid angle under which the outside is seen; that is also the share of random directions
        // that meet it.
        Shape shape = Make(kind);
        ShapeBatch batch = shape.CreateBatch([shape]);
        double mean = 0;
        int samples = 0;
        ForEachSample(shape, (from, sample, _) => mean += IsSeen(batch, from, sample) ? sample.InversePdf[0] : 0, ref samples, new(0.5f, 3, 1));
        var random = new Random(3 + TestSettings.Seed);
        const int rays = 400_000;
        int hits = 0;
        for (int i = 0; i < rays; i++)
        {
            float z = (2 * random.NextSingle()) - 1;
            float phi = 2 * MathF.PI * random.NextSingle();
            float r = MathF.Sqrt(1 - (z * z));
            FloatW distance = float.PositiveInfinity;
            UIntW primitive = 99u;
            batch.ClosestHit(new Vector3(0.5f, 3, 1), new Vector3(r * MathF.Cos(phi), r * MathF.Sin(phi), z), ref distance, ref primitive);
            hits += primitive[0] == 0 ? 1 : 0;
        }

        ErrorBudget.Lights.Check(PValues.Binomial(hits, rays, mean / samples / (4 * Math.PI)), $"random directions that meet the {kind}");
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Sampled_uv_is_the_uv_of_the_hit(string kind)
    {
        Shape shape = Make(kind);
        ShapeBatch batch = shape.CreateBatch([shape]);
        ForEachSample(shape, (from, sample, _) =>
        {
            SurfaceW surface = default;
            surface.Point = Vec3W.MultiplyAdd(sample.Direction, sample.Distance, from);
            batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: true, ref surface);
            Assert.InRange(Math.Abs(surface.U[0] - sample.U[0]), 0, 2e-3);
            Assert.InRange(Math.Abs(surface.V[0] - sample.V[0]), 0, 2e-3);
            Assert.InRange(-Vec3W.Dot(surface.Normal, sample.Direction)[0], sample.Cosine[0] - 2e-3, sample.Cosine[0] + 2e-3);
        });
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Points_move_with_uv_as_the_tangents_tell(string kind)
    {
        const float Step = 1e-3f;
        Shape shape = Make(kind);
        ShapeBatch batch = shape.CreateBatch([shape]);
        int count = 0;
        ForEachSample(shape, (from, sample, _) =>
        {
            SurfaceW here = default;
            here.Point = Vec3W.MultiplyAdd(sample.Direction, sample.Distance, from);
            batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: true, ref here);
            batch.DescribeTangents(new PrimitiveIndex(0, batch.Stride), ref here);
            foreach (bool alongU in new[] { true, false })
            {
                Vec3W along = alongU ? here.AlongU : here.AlongV;
                SurfaceW there = here;
                there.Point = Vec3W.MultiplyAdd(along, Step, here.Point);
                batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: true, ref there);
                (float u, float v) = (there.U[0] - here.U[0], there.V[0] - here.V[0]);
                Assert.True(FloatW.Abs(Vec3W.Dot(along, here.Normal))[0] < 1e-4f * FloatW.Sqrt(Vec3W.Dot(along, along))[0], $"{kind}: a tangent leaves the surface");

                // Not across an edge, the seam of a picture, or near the poles of a sphere.
                if (Vec3W.Dot(here.Normal, there.Normal)[0] > 0.99f && Math.Abs(u) < 0.1f && Math.Abs(v) < 0.1f && !(shape is Sphere && here.V[0] is < 0.1f or > 0.9f))
                {
                    Assert.InRange(u, (alongU ? Step : 0) - (0.05f * Step), (alongU ? Step : 0) + (0.05f * Step));
                    Assert.InRange(v, (alongU ? 0 : Step) - (0.05f * Step), (alongU ? 0 : Step) + (0.05f * Step));
                    count++;
                }
            }
        });
        Assert.True(count > 100, $"{count} points");
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Occlusion_agrees_with_the_nearest_hit(string kind)
    {
        Shape shape = Make(kind);
        ShapeBatch batch = shape.CreateBatch([shape]);
        var random = new Random(5);
        int blocked = 0;
        for (int i = 0; i < 20_000; i++)
        {
            Vector3 from = 4 * RandomVector(random);
            Vector3 to = 4 * RandomVector(random);
            Vector3 direction = Vector3.Normalize(to - from);
            float length = Vector3.Distance(from, to);
            FloatW distance = float.PositiveInfinity;
            UIntW primitive = 99u;
            batch.ClosestHit(from, direction, ref distance, ref primitive);
            if (Math.Abs(distance[0] - length) < 1e-4f * length || Grazes(shape, from, direction))
            {
                continue;
            }

            MaskW free = MaskW.All;
            batch.Occlude(from, direction, length, skip: -1, ref free);
            Assert.Equal(distance[0] < length, !free.Any);
            blocked += free.Any ? 0 : 1;
            free = MaskW.All;
            batch.Occlude(from, direction, length, skip: 0, ref free);
            Assert.True(free.Any || shape is Torus);
        }

        Assert.True(blocked > 100);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_ray_that_starts_at_the_offset_does_not_meet_its_own_surface(string kind)
    {
        Shape shape = Make(kind);
        ShapeBatch batch = shape.CreateBatch([shape]);
        var random = new Random(11);
        ForEachSample(shape, (from, sample, _) =>
        {
            SurfaceW surface = default;
            surface.Point = Vec3W.MultiplyAdd(sample.Direction, sample.Distance, from);
            batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: false, ref surface);
            Vector3 normal = ToVector(surface.Normal);
            Vector3 outward = Vector3.Normalize(RandomVector(random));
            outward = Vector3.Dot(outward, normal) < 0 ? -outward : outward;
            FloatW distance = float.PositiveInfinity;
            UIntW primitive = 99u;
            batch.ClosestHit(Vec3W.MultiplyAdd(surface.Normal, surface.Offset, surface.Point), outward, ref distance, ref primitive);

            // A torus may be met on its other side, or nearby where it is hollow.
            Assert.True(primitive[0] == 99u || shape is Torus);
        });
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Bounds_are_the_smallest_around_all_points(string kind)
    {
        Shape shape = Make(kind);
        Vector3 minimum = new(float.PositiveInfinity), maximum = new(float.NegativeInfinity);
        int samples = 0;
        foreach (Vector3 from in new Vector3[] { new(9, 2, 1), new(-9, -2, -1), new(1, 9, 2), new(-1, -9, -2), new(2, 1, 9), new(-2, -1, -9) })
        {
            ForEachSample(shape, (_, sample, _) =>
            {
                Vector3 p = ToVector(Vec3W.MultiplyAdd(sample.Direction, sample.Distance, from));
                (minimum, maximum) = (Vector3.Min(minimum, p), Vector3.Max(maximum, p));
            }, ref samples, from);
        }

        Vector3 slack = new(1e-5f);
        Assert.Equal(Vector3.Min(minimum, shape.Bounds.Minimum - slack), shape.Bounds.Minimum - slack);
        Assert.Equal(Vector3.Max(maximum, shape.Bounds.Maximum + slack), shape.Bounds.Maximum + slack);
        Assert.InRange((minimum - shape.Bounds.Minimum).Largest(), -1e-5f, 0.15f);
        Assert.InRange((shape.Bounds.Maximum - maximum).Largest(), -1e-5f, 0.15f);
    }

    [Fact]
    public void The_nearest_of_several_solids_is_met_and_of_equal_ones_the_first()
    {
        Shape[] boxes =
        [
            new Box(s_material, "", new(5, -1, -1), new(6, 1, 1)), new Box(s_material, "", new(2, -1, -1), new(3, 1, 1)),
            new Box(s_material, "", new(2, -2, -2), new(4, 2, 2)), new Box(s_material, "", new(-3, -1, -1), new(-2, 1, 1)),
        ];
        ShapeBatch batch = boxes[0].CreateBatch(boxes);
        FloatW distance = float.PositiveInfinity;
        UIntW primitive = 99u;
        batch.ClosestHit(Vector3.Zero, Vector3.UnitX, ref distance, ref primitive);
        Assert.Equal((2f, 1u), (distance[0], primitive[0]));
        foreach ((int skip, float end, bool isFree) in new[] { (-1, 2.5f, false), (1, 2.5f, false), (1, 1.9f, true), (0, 1.9f, true) })
        {
            MaskW free = MaskW.All;
            batch.Occlude(Vector3.Zero, Vector3.UnitX, end, skip, ref free);
            Assert.Equal(isFree, free.Any);
        }
    }

    [Fact]
    public void Pictures_stand_upright_on_boxes_and_around_cylinders()
    {
        static (float U, float V) At(Shape shape, Vector3 p)
        {
            ShapeBatch batch = shape.CreateBatch([shape]);
            SurfaceW surface = default;
            surface.Point = p;
            batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: true, ref surface);
            return (MathF.Round(surface.U[0], 3), MathF.Round(surface.V[0], 3));
        }

        Box box = new(s_material, "", Vector3.Zero, new(2, 4, 8));
        Assert.Equal((0.25f, 0.75f), At(box, new(0.5f, 3, 8)));
        Assert.Equal((0.75f, 0.75f), At(box, new(0.5f, 3, 0)));
        Assert.Equal((0.25f, 0.75f), At(box, new(2, 3, 6)));
        Assert.Equal((0.75f, 0.75f), At(box, new(0, 3, 6)));
        Assert.Equal((0.25f, 0.75f), At(box, new(0.5f, 4, 2)));
        Assert.Equal((0.75f, 0.75f), At(box, new(0.5f, 0, 2)));
        foreach (Shape round in new Shape[]
        {
            new Cylinder(s_material, "", Vector3.Zero, new(0, 4, 0), 1, caps: true), new Cone(s_material, "", Vector3.Zero, new(0, 4, 0), 1, 1, caps: true),
        })
        {
            Assert.Equal((0.5f, 0.75f), At(round, new(0, 3, 1)));
            Assert.Equal((0.75f, 0.25f), At(round, new(1, 1, 0)));
            Assert.Equal((0.25f, 0.25f), At(round, new(-1, 1, 0)));
            Assert.Equal((0.75f, 0.375f), At(round, new(0.5f, 4, 0.25f)));
            Assert.Equal((0.25f, 0.375f), At(round, new(0.5f, 0, 0.25f)));
        }

        Torus ring = new(s_material, "", Vector3.Zero, Vector3.UnitY, 2, 1);
        Assert.Equal((0.5f, 0.5f), At(ring, new(0, 0, 3)));
        Assert.Equal((0.75f, 0.75f), At(ring, new(2, 1, 0)));
        Assert.Equal((0.25f, 0.25f), At(ring, new(-2, -1, 0)));
        Rectangle card = new(s_material, "", new(1, 1, 1), new(2, 0, 0), new(1, 4, 0));
        Assert.Equal((0.5f, 0.25f), At(card, new(2.25f, 2, 1)));
        Disk plate = new(s_material, "", new(1, 1, 1), Vector3.UnitZ, 2);
        Assert.Equal((0.75f, 0.25f), At(plate, new(2, 0, 1)));
    }

    [Fact]
    public void Rays_from_inside_a_sphere_meet_it_and_segments_inside_are_free()
    {
        Shape sphere = new Sphere(s_material, "", new(1, 2, 3), 2);
        ShapeBatch batch = sphere.CreateBatch([sphere]);
        FloatW distance = float.PositiveInfinity;
        UIntW primitive = 99u;
        batch.ClosestHit(new Vector3(1, 2, 3), new Vector3(0, 1, 0), ref distance, ref primitive);
        Assert.Equal(2, distance[0], 5);
        MaskW free = MaskW.All;
        batch.Occlude(new Vector3(1, 2, 3), new Vector3(0, 1, 0), 1.9f, -1, ref free);
        Assert.True(free.Any);
        batch.Occlude(new Vector3(1, 2, 3), new Vector3(0, 1, 0), 2.1f, -1, ref free);
        Assert.False(free.Any);
    }

    [Fact]
    public void Infinite_planes_are_met_from_both_sides_and_uv_counts_scene_units()
    {
        Shape floor = new Plane(s_material, "", new(0, 1, 0), Vector3.UnitY, null);
        ShapeBatch batch = floor.CreateBatch([floor]);
        foreach (float side in new[] { -1f, 1f })
        {
            FloatW distance = float.PositiveInfinity;
            UIntW primitive = 99u;
            batch.ClosestHit(new Vector3(0, 1 + (3 * side), 0), new Vector3(0, -side, 0), ref distance, ref primitive);
            Assert.Equal(3, distance[0], 5);
        }

        SurfaceW surface = default;
        surface.Point = new Vector3(2.5f, 1, -4);
        batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: true, ref surface);
        Assert.Equal(2.5f, surface.U[0], 5);
        Assert.Equal(4, surface.V[0], 5);
        Assert.False(floor.Bounds.IsFinite);
    }

    [Fact]
    public void Pictures_stand_upright_on_a_sphere_seen_from_the_front()
    {
        Shape sphere = new Sphere(s_material, "", Vector3.Zero, 1);
        ShapeBatch batch = sphere.CreateBatch([sphere]);
        (float u, float v) At(Vector3 p)
        {
            SurfaceW surface = default;
            surface.Point = p;
            batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: true, ref surface);
            return (surface.U[0], surface.V[0]);
        }

        Assert.Equal(0.5f, At(new(0, 0, 1)).u, 5);
        Assert.True(At(new(0.5f, 0, 0.8f)).u > 0.5f);
        Assert.Equal(1, At(new(0, 1, 0)).v, 5);
        Assert.Equal(0, At(new(0, -1, 0)).v, 5);
    }

    [Fact]
    public void Small_and_far_sphere_lights_keep_their_solid_angle()
    {
        Sphere lamp = new(s_material, "", new(0, 0, 1000), 0.01f) { LightSampling = SphereLightSampling.Cone };
        lamp.SamplePoint(Vector3.Zero, 0.3f, 0.7f, out ShapeSampleW sample);
        double expected = Math.PI * 1e-4 / 1e6;
        Assert.InRange(sample.InversePdf[0], expected * 0.9999, expected * 1.0001);
    }

    private static Shape Make(string kind) => kind switch
    {
        "sphere" => new Sphere(s_material, "", new(0.2f, -0.3f, 0.1f), 1.2f),
        "surface sphere" => new Sphere(s_material, "", new(0.2f, -0.3f, 0.1f), 1.2f) { LightSampling = SphereLightSampling.Surface },
        "rectangle" => new Plane(s_material, "", new(0.1f, 0.2f, -0.3f), Vector3.Normalize(new(0.2f, 1, 0.3f)), new Vector2(2, 3)),
        "disk" => new Disk(s_material, "", new(0.1f, 0.2f, -0.3f), Vector3.Normalize(new(0.2f, 1, 0.3f)), 1.3f),
        "parallelogram" => new Rectangle(s_material, "", new(-1, 0.1f, 1), new(2, 0.3f, 0.5f), new(0.4f, 0.2f, -1.7f)),
        "box" => new Box(s_material, "", new(-0.8f, 0.6f, 0.8f), new(0.9f, -0.5f, -0.7f)),
        "turned box" => TurnedBoxes.Make(s_material, new(0.1f, 0.1f, -0.1f), new(0.3f, 1, 0.2f), 25, new(0.8f, 0.5f, 0.7f)),
        "cylinder" => new Cylinder(s_material, "", new(-0.2f, -0.6f, 0.1f), new(0.3f, 0.7f, -0.2f), 0.8f, caps: true),
        "cone" => new Cone(s_material, "", new(-0.2f, -0.6f, 0.1f), new(0.3f, 0.7f, -0.2f), 0.8f, 0, caps: true),
        "frustum" => new Cone(s_material, "", new(-0.2f, -0.6f, 0.1f), new(0.3f, 0.7f, -0.2f), 0.5f, 0.9f, caps: true),
        "torus" => new Torus(s_material, "", new(0.1f, -0.1f, 0.2f), new(0.8f, 1, 0.4f), 1.1f, 0.35f),
        _ => new Triangle(s_material, "", new(-1, 0, 1), new(1.5f, 0.3f, 1), new(0.1f, 0.2f, -1.5f), new(0, 0), new(2, 0), new(0, 3)),
    };

    private static void ForEachSample(Shape shape, Action<Vec3W, ShapeSampleW, int> action)
    {
        int count = 0;
        ForEachSample(shape, action, ref count, new(0.5f, 3, 1));
    }

    private static void ForEachSample(Shape shape, Action<Vec3W, ShapeSampleW, int> action, ref int count, Vector3 from)
    {
        const int side = 64;
        for (int i = 0; i < side * side; i++)
        {
            shape.SamplePoint(from, ((i % side) + 0.5f) / side, ((i / side) + 0.5f) / side, out ShapeSampleW sample);
            count++;
            if (sample.InversePdf[0] > 0 && sample.Cosine[0] > 0.03f)
            {
                action(from, sample, i);
            }
            else if (sample.InversePdf[0] > 0 && shape is not FlatShape)
            {
                action(from, sample, i);
            }
        }
    }

    // Whether no other part of the shape hides a point.
    private static bool IsSeen(ShapeBatch batch, Vec3W from, ShapeSampleW sample)
    {
        MaskW free = MaskW.All;
        batch.Occlude(from, sample.Direction, sample.Distance, skip: 0, ref free);
        return free.Any;
    }

    private static bool Grazes(Shape shape, Vector3 from, Vector3 direction)
    {
        if (shape is not Sphere sphere)
        {
            return false;
        }

        Vector3 toCenter = sphere.Center - from;
        Vector3 off = toCenter - (direction * Vector3.Dot(toCenter, direction));
        return Math.Abs(off.Length() - sphere.Radius) < 1e-4f;
    }

    private static Vector3 RandomVector(Random random) =>
        new((2 * random.NextSingle()) - 1, (2 * random.NextSingle()) - 1, (2 * random.NextSingle()) - 1);

    private static Vector3 ToVector(Vec3W v) => new(v.X[0], v.Y[0], v.Z[0]);
}
