using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Tests.Shapes;

/// <summary>
/// Solids keep rays in, and tori miss none, against arithmetic in double precision.
/// Covers `BoxKernel`, `ConicalKernel` and `TorusKernel`.
/// </summary>
[Trait("Category", "Thorough")]
public class SolidShapeTests
{
    private const double Roundoff = 1.0 / (1 << 24);
    private static readonly Material s_material = new DiffuseMaterial(new SolidTexture(Rgb.White));

    public static TheoryData<string> Solids() => ["box", "turned box", "cylinder", "cone", "needle", "plate", "frustum", "torus"];

    [Theory]
    [MemberData(nameof(Solids))]
    public void No_ray_that_goes_inside_leaks_out_at_an_edge(string kind)
    {
        Random random = new(TestSettings.Seed);
        int leaks = 0, rays = 0;
        for (int turn = 0; turn < TestSettings.Scale(300, 10_000); turn++)
        {
            Shape shape = Make(kind, random, new[] { 0f, 3f, 100f }[turn % 3]);
            ShapeBatch batch = shape.CreateBatch([shape]);
            for (int packet = 0; packet < 20; packet++)
            {
                // A ray from anywhere to the edges enters, and goes on to the edges.
                Bounds bounds = shape.Bounds;
                Vector3 size = bounds.Maximum - bounds.Minimum;
                Vector3[] from = [.. Each(() => bounds.Minimum + (size * Cube(random)) + (size * 3 * Vector3.Normalize(Cube(random) - new Vector3(0.5f))))];
                Vec3W origin = Pack(from);
                Vec3W direction = Pack([.. from.Select(f => Vector3.Normalize(Target(shape, random) - f))]);
                FloatW distance = float.PositiveInfinity;
                UIntW primitive = 99u;
                batch.ClosestHit(origin, direction, ref distance, ref primitive);
                MaskW hit = UIntW.Equal(primitive, 0u);
                SurfaceW surface = default;
                surface.Point = hit.Select(Vec3W.MultiplyAdd(direction, distance, origin), Pack([.. Each(() => Target(shape, random))]));
                batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: false, ref surface);
                Vec3W inside = Vec3W.NegatedMultiplyAdd(surface.Normal, surface.Offset, surface.Point);
                Vec3W towards = Vec3W.Normalize(Pack([.. Each(() => Target(shape, random))]) - inside);
                MaskW inwards = Vec3W.Dot(towards, surface.Normal) < 0f;
                distance = float.PositiveInfinity;
                primitive = 99u;
                batch.ClosestHit(inside, towards, ref distance, ref primitive);
                MaskW free = MaskW.All;
                batch.Occlude(inside, towards, 1000f, skip: -1, ref free);
                leaks += BitOperations.PopCount((inwards & (free | UIntW.Equal(primitive, 99u))).Bits);
                rays += BitOperations.PopCount(inwards.Bits);
            }
        }

        Assert.True(rays > 10_000);
        Assert.True(leaks == 0, $"{leaks} of {rays} rays leak");
    }

    [Theory]
    [InlineData(0.001f)]
    [InlineData(0.03f)]
    [InlineData(0.3f)]
    [InlineData(0.7f)]
    [InlineData(0.999f)]
    public void Rays_that_touch_a_torus_meet_it_where_exact_arithmetic_first_enters_it(float ratio)
    {
        Random random = new(TestSettings.Seed);
        int met = 0;
        for (int turn = 0; turn < TestSettings.Scale(4000, 80_000); turn++)
        {
            Vector3 center = (Cube(random) - new Vector3(0.5f)) * new[] { 0f, 4f, 100f }[turn % 3];
            Torus torus = new(s_material, "", center, Cube(random) - new Vector3(0.5f), 1, ratio);
            SolidReference exact = new(torus);
            double unit = Roundoff * (Vector3.Abs(center).Largest() + 2);

            // Along the surface, now and then deeper than rounding or above it.
            SurfaceW surface = default;
            surface.Point = Target(torus, random);
            ShapeBatch batch = torus.CreateBatch([torus]);
            batch.Describe(new PrimitiveIndex(0, batch.Stride), needsUv: false, ref surface);
            (Vector3 point, Vector3 normal) = (At(surface.Point), At(surface.Normal));
            Vector3 along = Vector3.Normalize(Vector3.Cross(normal, Cube(random) - new Vector3(0.5f)));
            double depth = ratio * Math.Pow(10, -7 * random.NextDouble()) * (random.Next(4) - 1);
            float away = 5 * random.NextSingle();
            Vector3 from = point - (normal * (float)depth) - (along * away);
            FloatW distance = float.PositiveInfinity;
            UIntW primitive = 99u;
            batch.ClosestHit(from, along, ref distance, ref primitive);

            Double3 start = new(from);
            Double3 unitDirection = new Double3(along).Unit;
            double Signed(double t) => exact.Signed(start + (unitDirection * t));
            double side = Signed(0) > 0 ? 1 : -1;
            if (Math.Abs(Signed(0)) < 16 * unit)
            {
                continue;
            }

            double last = Math.Min(distance[0], 20);
            for (int i = 0; i < 200; i++)
            {
                Assert.True(Signed(last * i / 200) * side > -8 * unit, $"crossed before {distance[0]}");
            }

            // The place where it was aimed at, as near as can be seen.
            Assert.True(Signed(away) * side > -8 * unit || distance[0] < away, $"not met before {away}");
            if (primitive[0] == 0)
            {
                met++;
                Assert.InRange(Math.Abs(Signed(distance[0])), 0, 8 * unit);
            }
        }

        Assert.True(met > 1000);
    }

    private static IEnumerable<Vector3> Each(Func<Vector3> make) => Enumerable.Range(0, FloatW.Count).Select(_ => make());

    private static Vector3 Cube(Random random) => new(random.NextSingle(), random.NextSingle(), random.NextSingle());

    private static Shape Make(string kind, Random random, float away)
    {
        Vector3 place = (Cube(random) - new Vector3(0.5f)) * away;
        Vector3 axis = random.Next(3) == 0 ? Vector3.UnitY : Vector3.Normalize(Cube(random) - new Vector3(0.5f));
        float size = 0.5f + random.NextSingle();
        return kind switch
        {
            "box" => new Box(s_material, "", place, place + new Vector3(0.2f) + Cube(random)),
            "turned box" => TurnedBoxes.Make(s_material, place, axis, 360 * random.NextSingle(), new Vector3(0.1f) + (0.5f * Cube(random))),
            "cylinder" => new Cylinder(s_material, "", place, place + axis, size, caps: true),
            "cone" => new Cone(s_material, "", place, place + axis, size, 0, caps: true),
            "needle" => new Cone(s_material, "", place, place + axis, 0.03f * size, 0, caps: true),
            "plate" => new Cone(s_material, "", place, place + (axis * 0.01f), size, 0.3f * random.Next(3), caps: true),
            "frustum" => new Cone(s_material, "", place, place + axis, size, 0.1f + random.NextSingle(), caps: true),
            _ => new Torus(s_material, "", place, axis, size, size * (0.05f + (0.9f * random.NextSingle()))),
        };
    }

    // A point of the edges, or of a torus, as near as floats come to it.
    private static Vector3 Target(Shape shape, Random random)
    {
        float part = random.Next(3) == 0 ? random.Next(2) : random.NextSingle();
        double turn = 2 * Math.PI * random.NextDouble();
        switch (shape)
        {
            case Box box:
                Vector3 p = new(random.Next(2), random.Next(2), random.Next(2));
                p[random.Next(3)] = part;
                return box.Bounds.Minimum + ((box.Bounds.Maximum - box.Bounds.Minimum) * p);
            case TurnedBox turned:
                Vector3 corner = new(random.Next(2), random.Next(2), random.Next(2));
                corner[random.Next(3)] = part;
                Vector3 within = turned.Half * ((2 * corner) - Vector3.One);
                return turned.Center + (turned.Axes.X * within.X) + (turned.Axes.Y * within.Y) + (turned.Axes.Z * within.Z);
            case ConicalShape s:
                Vector3 axis = s.Top - s.Bottom;
                Vector3 first = Vector3.Normalize(Vector3.Cross(axis, Math.Abs(axis.X) < Math.Abs(axis.Y) ? Vector3.UnitX : Vector3.UnitY));
                Vector3 second = Vector3.Normalize(Vector3.Cross(axis, first));
                Vector3 across = (first * (float)Math.Cos(turn)) + (second * (float)Math.Sin(turn));
                return random.Next(3) switch
                {
                    0 => s.Bottom + (across * s.Radius),
                    1 => s.Top + (across * s.TopRadius),
                    _ => s.Bottom + (axis * part) + (across * (s.Radius + (part * (s.TopRadius - s.Radius)))),
                };
            default:
                var torus = (Torus)shape;
                Vector3 up = Vector3.Normalize(torus.Axis);
                Vector3 outwards = Vector3.Normalize(Vector3.Cross(up, Cube(random) - new Vector3(0.5f)));
                return torus.Center + (outwards * (torus.Radius + (torus.TubeRadius * (float)Math.Cos(turn)))) + (up * (torus.TubeRadius * (float)Math.Sin(turn)));
        }
    }

    private static Vec3W Pack(Vector3[] v) => new(Lanes(v, 0), Lanes(v, 1), Lanes(v, 2));

    private static FloatW Lanes(Vector3[] v, int axis) => new(new Vector<float>([.. v.Select(p => p[axis])]));

    private static Vector3 At(in Vec3W v) => new(v.X[0], v.Y[0], v.Z[0]);
}
