using System.Numerics;
using FsCheck;
using FsCheck.Fluent;
using RayTracer.Numerics;
using RayTracer.Shapes;
using Plane = RayTracer.Shapes.Plane;

namespace RayTracer.Tests.Shapes;

/// <summary>
/// What holds for rays and shapes of any size and place. Errors are bounded in units of u·M: unit roundoff 2⁻²⁴ times the largest
/// coordinate of the scene.
/// Covers `ShapeBatch` and `RayOffset`.
/// </summary>
[Trait("Category", "Thorough")]
public class RayPropertyTests
{
    private const double Roundoff = 1.0 / (1 << 24);

    // Rays that graze a surface are as badly conditioned as 1/cosine; their hits are left to the statistics of pictures.
    private const double Grazing = 0.1;

    public static TheoryData<string> Kinds() => [.. RandomShape.Kinds];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Hits_are_where_exact_arithmetic_finds_them(string kind) => ForAllRays(kind, (shape, origin, direction) =>
    {
        (double distance, double cosine, double outside) = shape.Expected(origin, direction);
        double unit = Roundoff * shape.Largest;
        if (cosine < Grazing || Math.Abs(outside) < 64 * unit / Grazing || !IsWellShaped(shape))
        {
            return;
        }

        float found = shape.Hit(origin, direction);
        Assert.Equal(double.IsInfinity(distance), float.IsInfinity(found));
        if (!float.IsInfinity(found))
        {
            Assert.InRange(Math.Abs(found - distance) * cosine, 0, 64 * unit);
        }
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Hit_points_lie_on_the_shape(string kind) => ForAllHits(kind, (shape, origin, direction, distance) =>
    {
        (Vector3 point, Vector3 normal, _, _) = shape.Describe(origin, direction, distance);
        (double off, double outside) = shape.Measure(new(point));
        double unit = Roundoff * shape.Largest;
        Assert.InRange(Math.Abs(off), 0, 24 * unit);
        Assert.InRange(outside, double.NegativeInfinity, 64 * unit / Grazing);
        Assert.InRange(Math.Abs(normal.Length() - 1), 0, 1e-6);

        // The normal is the direction in which the distance grows.
        double step = 1e-3 * shape.Reach;
        Assert.Equal(off + step, shape.Measure(new Double3(point) + (new Double3(normal) * step)).Off, 64 * unit);
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Segments_are_blocked_if_and_only_if_the_nearest_hit_is_before_their_end(string kind) => ForAllHits(kind, (shape, origin, direction, distance) =>
    {
        float margin = (float)(64 * Roundoff / Grazing * shape.Largest);
        Assert.False(shape.IsFree(origin, direction, distance + margin));
        Assert.False(shape.IsFree(origin, direction, (distance * 1.5f) + margin) && shape.Shape is not Sphere);
        if (distance > margin)
        {
            Assert.True(shape.IsFree(origin, direction, distance - margin));
            Assert.True(shape.IsFree(origin, direction, distance * 0.5f));
        }
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Rays_that_leave_a_surface_do_not_meet_it_where_they_start(string kind) => ForAllHits(kind, (shape, origin, direction, distance) =>
    {
        (Vector3 point, Vector3 normal, float offset, _) = shape.Describe(origin, direction, distance);
        for (int side = -1; side <= 1; side += 2)
        {
            Vector3 start = Vec(Vec3W.MultiplyAdd(normal, side * offset, point));
            Vector3 leaving = shape.Leaving(side * normal);
            float again = shape.Hit(start, leaving);
            if (shape.Shape is Sphere sphere && side < 0)
            {
                // From inside, the sphere is met at the far end of a chord.
                Assert.InRange(again, sphere.Radius * -Vector3.Dot(leaving, normal), 2.1f * sphere.Radius);
            }
            else if (shape.Shape is Torus || (side < 0 && shape.Solid is not null))
            {
                AssertCrosses(shape, start, leaving, again, side, offset);
            }
            else
            {
                Assert.True(float.IsInfinity(again), $"met again at {again}, side {side}, offset {offset}");
                Assert.True(shape.IsFree(start, leaving, 8 * shape.Reach));
            }
        }
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Rays_start_less_than_32_units_in_the_last_place_off_the_surface(string kind) => ForAllHits(kind, (shape, origin, direction, distance) =>
    {
        (Vector3 point, _, float offset, _) = shape.Describe(origin, direction, distance);
        float largest = Math.Max(Vector3.Abs(point).Largest(), shape.OffsetScale(point));
        Assert.InRange(offset, float.Epsilon, 31.999f * (MathF.BitIncrement(largest) - largest));
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Sampled_points_have_the_uv_of_the_hit(string kind) => ForAll(kind, shape =>
    {
        if (shape.Shape is Plane { Size: null } || !IsWellShaped(shape))
        {
            return;
        }

        Vector3 from = shape.Ray().Origin;
        Vector3 uv = (shape.Vector() * 0.5f) + new Vector3(0.5f);
        shape.Shape.SamplePoint(from, uv.X, uv.Y, out ShapeSampleW sample);
        Vector3 direction = Vec(sample.Direction);
        double margin = 1024 * Roundoff * shape.Largest;
        if (Math.Abs(sample.Cosine[0]) < Grazing || !(sample.InversePdf[0] > 0) || shape.Solid?.IsNearEdge(new Double3(from) + (new Double3(direction) * sample.Distance[0]), margin) == true)
        {
            return;
        }

        (_, _, _, Vector2 described) = shape.Describe(from, direction, sample.Distance[0]);
        double tolerance = 512 * Roundoff * shape.Largest / shape.Reach;
        if (shape.Shape is Sphere)
        {
            // Longitudes come close together towards the poles, and 0 is 1.
            tolerance /= Math.Max(1e-3, Math.Sin(Math.PI * described.Y));
            Assert.InRange(Math.Abs(Math.IEEERemainder(described.X - sample.U[0], 1)), 0, tolerance);
            Assert.InRange(Math.Abs(described.Y - sample.V[0]), 0, Math.Max(tolerance, 1e-3));
        }
        else if (shape.Solid is not null)
        {
            // Around an axis, 0 is 1 too, and thin shapes spread their errors.
            Assert.InRange(Math.Abs(Math.IEEERemainder(described.X - sample.U[0], 1)), 0, 10 * tolerance / Grazing);
            Assert.InRange(Math.Abs(Math.IEEERemainder(described.Y - sample.V[0], 1)), 0, 10 * tolerance / Grazing);
        }
        else
        {
            Assert.InRange(Math.Abs(described.X - sample.U[0]), 0, tolerance / Grazing);
            Assert.InRange(Math.Abs(described.Y - sample.V[0]), 0, tolerance / Grazing);
        }
    });

    [Fact]
    public void The_front_of_a_triangle_is_where_its_corners_go_counter_clockwise() => ForAll("triangle", shape =>
    {
        if (!IsWellShaped(shape))
        {
            return;
        }

        Triangle t = (Triangle)shape.Shape;
        Vector3 mirror = new(-1, 1, 1);
        Triangle swapped = new(t.Material, "", t.A, t.C, t.B, default, default, default);
        Triangle mirrored = new(t.Material, "", t.A * mirror, t.B * mirror, t.C * mirror, default, default, default);
        Double3 front = Double3.Cross(new Double3(t.B) - t.A, new Double3(t.C) - t.A).Unit;
        float tolerance = 512 * shape.Largest / shape.Reach / (1 << 24);
        Assert.InRange((new Double3(t.Normal) - front).Length, 0, tolerance);
        Assert.InRange((t.Normal + swapped.Normal).Length(), 0, tolerance);
        Assert.InRange((t.Normal + (mirrored.Normal * mirror)).Length(), 0, tolerance);
    });

    // A ray leaves a surface into or around a solid: what it meets next is not where it started. Its way there is on the side where it began.
    private static void AssertCrosses(RandomShape shape, Vector3 start, Vector3 direction, float again, int side, float offset)
    {
        if (float.IsInfinity(again))
        {
            Assert.True(side > 0 || !shape.Solid!.IsClosed, "a ray left a closed shape");
            Assert.True(shape.IsFree(start, direction, 8 * shape.Reach));
            return;
        }

        Double3 from = new(start);
        Double3 unit = new Double3(direction).Unit;
        double off = shape.Measure(from + (unit * again)).Off;
        Assert.True(Math.Abs(off) < 0.75 * offset, $"met at {again}, but {off / offset} offsets off, side {side}");
        for (int i = 1; i < 8; i++)
        {
            double between = shape.Solid!.Signed(from + (unit * (again * i / 8.0)));
            Assert.True(between * side > -offset / 3, $"{between / offset} offsets from the surface on the way to {again}, side {side}");
        }
    }

    private static void ForAll(string kind, Action<RandomShape> check)
    {
        Gen<(int Seed, int Exponent, int Away)> cases =
            from seed in Gen.Choose(0, int.MaxValue - 1)
            from exponent in Gen.Choose(-15, 15)
            from away in Gen.Elements(0, 0, 1, 30, 1000)
            select (seed, exponent, away);
        Config config = Config.QuickThrowOnFailure.WithReplay((ulong)TestSettings.Seed, 1).WithMaxTest(TestSettings.Scale(1500, 20_000));
        Check.One(config, Prop.ForAll(cases.ToArbitrary(), c =>
            check(new RandomShape(kind, c.Seed, MathF.ScaleB(1.37f, c.Exponent), c.Away))));
    }

    private static void ForAllRays(string kind, Action<RandomShape, Vector3, Vector3> check) => ForAll(kind, shape =>
    {
        for (int i = 0; i < 4; i++)
        {
            (Vector3 origin, Vector3 direction) = shape.Ray();

            // A ray that starts on the surface, as far as floats can tell, may meet it or not.
            if (Math.Abs(shape.Measure(new(origin)).Off) > 64 * Roundoff * shape.Largest)
            {
                check(shape, origin, direction);
            }
        }
    });

    private static void ForAllHits(string kind, Action<RandomShape, Vector3, Vector3, float> check) => ForAllRays(kind, (shape, origin, direction) =>
    {
        float distance = shape.Hit(origin, direction);
        if (!float.IsInfinity(distance) && shape.Expected(origin, direction).Cosine >= Grazing && IsWellShaped(shape))
        {
            check(shape, origin, direction, distance);
        }
    });

    // A needle's normal is as uncertain as its corners over its height.
    private static bool IsWellShaped(RandomShape shape) => shape.Shape is not Triangle t
        || t.Area > 0.1f * Math.Max(Vector3.DistanceSquared(t.A, t.B), Math.Max(Vector3.DistanceSquared(t.B, t.C), Vector3.DistanceSquared(t.C, t.A)));

    private static Vector3 Vec(in Vec3W v) => new(v.X[0], v.Y[0], v.Z[0]);
}
