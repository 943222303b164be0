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

    public static TheoryData<string> Kinds() => ["sphere", "surface sphere", "rectangle", "triangle"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_ray_to_a_sampled_point_meets_the_shape_there(string kind)
    {
        Shape shape = Make(kind);
        ShapeBatch batch = shape.CreateBatch([shape]);
        ForEachSample(shape, (from, sample, _) =>
        {
            FloatW distance = float.PositiveInfinity;
            UIntW primitive = 99u;
            batch.ClosestHit(from, sample.Direction, ref distance, ref primitive);
            Assert.Equal(0u, primitive[0]);
            Assert.InRange(distance[0], sample.Distance[0] * (1 - 2e-3f), sample.Distance[0] * (1 + 2e-3f));
        });
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
        ForEachSample(shape, (_, sample, _) => mean += sample.InversePdf[0], ref samples, new(0.5f, 3, 1));
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
            Assert.True(free.Any);
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
            Assert.Equal(99u, primitive[0]);
        });
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
            else if (sample.InversePdf[0] > 0 && shape is Sphere)
            {
                action(from, sample, i);
            }
        }
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
