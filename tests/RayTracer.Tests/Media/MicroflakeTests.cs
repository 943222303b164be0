using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Media;

/// <summary>Covers `Microflakes`: media of tiny mirrors, against their formulas in double precision, and Mitsuba.</summary>
[Trait("Category", "Thorough")]
public class MicroflakeTests
{
    private const int Bins = 16;
    private const int Fine = 24;
    private static readonly Vec3W s_point = new(0.5f, 0.5f, 0.5f);

    private static readonly Dictionary<string, float[]> s_matrices = new()
    {
        ["balls"] = [1, 1, 1, 0, 0, 0],
        ["sheets"] = [0.09f, 0.09f, 1, 0, 0, 0],
        ["fibres"] = [1, 0.16f, 1, 0, 0, 0],
        ["tilted"] = [0.9f, 0.3f, 0.15f, 0.2f, -0.1f, 0.05f],
        ["large"] = [3, 2, 5, 1, -2, 0.5f],
    };

    private static readonly Vector3[] s_directions = [new(0, 0, 1), new(0.6f, 0, -0.8f), new(-2 / 3f, 1 / 3f, 2 / 3f)];

    public static TheoryData<string> Names => [.. s_matrices.Keys];

    // D(m) and √(ωᵀSω), from the inverse matrix (Heitz et al. 2015, eq. 9 and 15).
    [Theory]
    [MemberData(nameof(Names))]
    public void Flakes_look_as_large_as_all_that_are_seen_together(string name)
    {
        Microflakes flakes = new(s_matrices[name]);
        foreach (Vector3 seen in s_directions)
        {
            double sum = 0;
            const int steps = 600;
            for (int i = 0; i < steps; i++)
            {
                for (int j = 0; j < steps; j++)
                {
                    Vector3 m = OfSphere((i + 0.5) / steps, (j + 0.5) / steps);
                    sum += double.Max(0, Vector3.Dot(m, seen)) * Normals(s_matrices[name], m) * 4 * Math.PI / (steps * steps);
                }
            }

            Assert.Equal(sum, flakes.Area(s_point, W(seen))[0], 2e-3 * sum);
            Assert.Equal(flakes.Area(s_point, W(seen))[0], flakes.LargestArea(W(-seen))[0]);
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Directions_are_chosen_by_the_phase_function_and_all_of_them(string name)
    {
        Microflakes flakes = new(s_matrices[name]);
        foreach (Vector3 before in s_directions)
        {
            int count = TestSettings.Scale(1 << 16, 1 << 20);
            double[] expected = new double[Bins * Bins];
            for (int i = 0; i < Bins * Fine; i++)
            {
                for (int j = 0; j < Bins * Fine; j++)
                {
                    Vector3 after = OfSphere((i + 0.5) / (Bins * Fine), (j + 0.5) / (Bins * Fine));
                    expected[(i / Fine * Bins) + (j / Fine)] += flakes.Evaluate(s_point, W(before), W(after))[0] * 4 * Math.PI / (Bins * Fine * Bins * Fine);
                }
            }

            Assert.Equal(1, expected.Sum(), 2e-3);
            double[] observed = new double[Bins * Bins];
            UnitSquare.AtRandom(count, (u, v, lane) =>
            {
                Vec3W after = flakes.Scatter(s_point, W(before), u, v);
                Assert.Equal(1, Vec3W.Dot(after, after)[lane], 1e-5);
                Assert.True(flakes.Evaluate(s_point, W(before), after)[lane] > 0);
                (int z, int turn) = ((int)((after.Z[lane] + 1) / 2 * Bins), (int)((Math.Atan2(after.Y[lane], after.X[lane]) / (2 * Math.PI) + 1) % 1 * Bins));
                observed[(int.Clamp(z, 0, Bins - 1) * Bins) + int.Min(turn, Bins - 1)]++;
            });
            ErrorBudget.Warps.Check(PValues.ChiSquared(observed, [.. expected.Select(e => e * count / expected.Sum())]), name);
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Light_and_eye_can_be_exchanged(string name)
    {
        Microflakes flakes = new(s_matrices[name]);
        foreach (Vector3 a in s_directions)
        {
            foreach (Vector3 b in s_directions.Where(d => d != a))
            {
                float there = (flakes.Area(s_point, W(a)) * flakes.Evaluate(s_point, W(a), W(b)))[0];
                Assert.Equal(there, (flakes.Area(s_point, W(b)) * flakes.Evaluate(s_point, W(-b), W(-a)))[0], 1e-5 * there);
            }
        }
    }

    // What Mitsuba 3.9.1 computes; there, the first direction points back along the ray.
    [Theory]
    [InlineData(1, 0, 0, 0, 1, 0, 0.1587704, 0.9486833)]
    [InlineData(0.6f, 0, 0.8f, 0, -0.6f, 0.8f, 0.008818731, 0.5692099)]
    [InlineData(-1, 2, 2, 2, -1, 2, 0.01654494, 0.5477226)]
    [InlineData(0, 0, 1, 0, 0.6f, 0.8f, 0.02836873, 0.3872983)]
    [InlineData(2, 3, -6, 6, 2, 3, 0.2371159, 0.5477226)]
    public void The_numbers_are_Mitsubas(float x, float y, float z, float toX, float toY, float toZ, double phase, double area)
    {
        (Vector3 from, Vector3 to) = (Vector3.Normalize(new(x, y, z)), Vector3.Normalize(new(toX, toY, toZ)));
        Microflakes flakes = new(s_matrices["tilted"]);
        Assert.Equal(phase, flakes.Evaluate(s_point, W(-from), W(to))[0], 5e-6 * phase + 1e-8);
        Assert.Equal(area, flakes.Area(s_point, W(from))[0], 1e-6);
    }

    // From one matrix to another along x: half-way, their mean.
    [Fact]
    public void A_grid_of_matrices_depends_on_the_place_and_is_never_seen_larger_than_it_says()
    {
        float[] a = s_matrices["tilted"];
        float[] b = s_matrices["fibres"];
        Microflakes between = new(new PlacedGrid(new VolumeGrid(2, 1, 1, 6, [.. a, .. b]), Transform.Identity, GridInterpolation.Trilinear, Wrapping.Clamp));
        Microflakes mean = new([.. a.Zip(b, (p, q) => (p + q) / 2)]);
        foreach (Vector3 d in s_directions)
        {
            Assert.Equal(mean.Area(s_point, W(d))[0], between.Area(s_point, W(d))[0], 1e-6);
            Assert.Equal(mean.Evaluate(s_point, W(d), W(s_directions[0]))[0], between.Evaluate(s_point, W(d), W(s_directions[0]))[0], 1e-5);
            Assert.All(new[] { 0, 0.3f, 0.5f, 0.8f, 1 }, x => Assert.InRange(between.Area(new(x, 0.5f, 0.5f), W(d))[0], 0.01f, between.LargestArea(W(d))[0] * 1.00001f));
        }
    }

    [Theory]
    [InlineData(true, 1, 1, 1, 0, 0, 0)]
    [InlineData(true, 1e-4f, 1e-4f, 1, 0, 0, 0)]
    [InlineData(false, 0, 1, 1, 0, 0, 0)]
    [InlineData(false, 1, 1, -1, 0, 0, 0)]
    [InlineData(false, 1, 1, 1, 1, 0, 0)]
    [InlineData(false, 1, 1, 1, 0.8f, 0.8f, 0.1f)]
    [InlineData(false, 0, 0, 0, 0, 0, 0)]
    public void What_is_no_ellipsoid_is_told(bool isOne, float xx, float yy, float zz, float xy, float xz, float yz) =>
        Assert.Equal(isOne, Microflakes.Complaint([xx, yy, zz, xy, xz, yz]) is null);

    [Fact]
    public void What_was_on_the_stack_before_is_no_part_of_the_largest_area()
    {
        PlacedGrid grid = new(new(1, 1, 1, 6, s_matrices["balls"]), Transform.Identity, GridInterpolation.Nearest, Wrapping.Clamp);
        for (int i = 0; i < 100; i++)
        {
            Soil();
            Assert.Equal(1, new Microflakes(grid).LargestArea(W(Vector3.UnitZ))[0], 1e-5f);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Soil()
    {
        Span<float> stack = stackalloc float[1 << 14];
        stack.Fill(1e6f);
        GC.KeepAlive(stack.ToArray());
    }

    private static double Normals(float[] s, Vector3 m)
    {
        (double xx, double yy, double zz, double xy, double xz, double yz) = (s[0], s[1], s[2], s[3], s[4], s[5]);
        double determinant = (xx * ((yy * zz) - (yz * yz))) - (xy * ((xy * zz) - (yz * xz))) + (xz * ((xy * yz) - (yy * xz)));
        double inverse = (m.X * m.X * ((yy * zz) - (yz * yz))) + (m.Y * m.Y * ((xx * zz) - (xz * xz))) + (m.Z * m.Z * ((xx * yy) - (xy * xy)))
            + (2 * ((m.X * m.Y * ((xz * yz) - (zz * xy))) + (m.X * m.Z * ((xy * yz) - (yy * xz))) + (m.Y * m.Z * ((xy * xz) - (xx * yz)))));
        return Math.Pow(determinant, 1.5) / (Math.PI * inverse * inverse);
    }

    private static Vector3 OfSphere(double u, double v)
    {
        double z = (2 * u) - 1;
        double r = Math.Sqrt(1 - (z * z));
        return new((float)(r * Math.Cos(2 * Math.PI * v)), (float)(r * Math.Sin(2 * Math.PI * v)), (float)z);
    }

    private static Vec3W W(Vector3 v) => new(v.X, v.Y, v.Z);
}
