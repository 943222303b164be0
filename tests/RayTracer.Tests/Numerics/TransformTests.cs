using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Tests.Numerics;

[Trait("Category", "Thorough")]
public class TransformTests
{
    [Fact]
    public void The_inverse_undoes_a_map()
    {
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 1000; i++)
        {
            Transform map = RandomMap(random);
            Transform both = map.Inverse() * map;
            Vector3 p = RandomVector(random);
            Assert.True((both.Point(p) - p).Norm() <= 1e-6f * (1 + p.Norm()), $"{map} takes {p} to {both.Point(p)}");
        }
    }

    [Theory]
    [InlineData(90)]
    [InlineData(-270)]
    [InlineData(450)]
    public void Quarter_turns_are_exact(float degrees)
    {
        Transform turn = Transform.Rotation(new(0, 3, 0), degrees);
        Assert.Equal(new(2, 5, -7), turn.Point(new(7, 5, 2)));
    }

    [Fact]
    public void Products_apply_the_right_map_first()
    {
        Transform map = Transform.Translation(new(1, 0, 0)) * Transform.Scaling(new(2, 3, 4));
        Assert.Equal(new(3, 3, 4), map.Point(Vector3.One));
        Assert.Equal(new(2, 3, 4), map.Vector(Vector3.One));
        Assert.Equal(24, map.Determinant);
    }

    [Fact]
    public void A_similarity_is_distinguished_from_other_maps()
    {
        Transform turned = Transform.Rotation(new(1, 2, 3), 77) * Transform.Scaling(new(-2, 2, 2));
        Assert.Equal(2, turned.UniformScale()!.Value, 1e-6);
        Assert.Null((turned * Transform.Scaling(new(1, 1.001f, 1))).UniformScale());
    }

    [Fact]
    public void Normals_stay_perpendicular_to_their_surface()
    {
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 1000; i++)
        {
            Transform map = RandomMap(random);
            Vector3 normal = RandomVector(random).Unit();
            Vector3 along = normal.Cross(RandomVector(random)).Unit();
            Assert.True(float.Abs(map.Inverse().TransposedVector(normal).Unit().Dot(map.Vector(along).Unit())) < 1e-5f);
        }
    }

    [Fact]
    public void Half_way_between_keyframes_a_thing_has_turned_half_the_angle_and_gone_half_the_way()
    {
        Transform start = Transform.Translation(new(1, 2, 3)) * Transform.Rotation(new(1, 1, 0), 20) * Transform.Scaling(new(1, 2, 3));
        Transform end = Transform.Translation(new(3, 2, 1)) * Transform.Rotation(new(1, 1, 0), 120) * Transform.Scaling(new(-3, -2, 1));
        Assert.True(start.Determinant > 0 && end.Determinant > 0);
        Motion motion = Motion.Between([(10, start), (12, end)]);
        Assert.Equal(start, motion.At(9));
        Assert.Equal(end, motion.At(13));

        // The end is a stretch of (−3, −2, 1), of which the nearest rotation is no identity: take one with an ordinary stretch.
        Transform plain = Transform.Translation(new(3, 2, 1)) * Transform.Rotation(new(1, 1, 0), 120) * Transform.Scaling(new(3, 2, 1));
        Transform middle = Motion.Between([(10, start), (12, plain)]).At(11);
        Transform expected = Transform.Translation(new(2, 2, 2)) * Transform.Rotation(new(1, 1, 0), 70) * Transform.Scaling(new(2, 2, 2));
        AssertClose(expected, middle, 1e-6);
    }

    [Fact]
    public void A_motion_passes_through_its_keyframes_without_a_jump()
    {
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 200; i++)
        {
            Transform[] places = [.. Enumerable.Range(0, 3).Select(_ => RandomMap(random, mirrors: false))];
            Motion motion = Motion.Between([(0, places[0]), (1, places[1]), (3, places[2])]);
            AssertClose(places[1], motion.At(1 - 1e-7), 1e-4);
            AssertClose(places[1], motion.At(1 + 1e-7), 1e-4);
            AssertClose(places[2], motion.At(3 - 1e-7), 1e-4);
        }
    }

    [Fact]
    public void The_box_of_a_motion_holds_all_that_moves()
    {
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < TestSettings.Scale(100, 2000); i++)
        {
            Motion inner = Motion.Between([(0, RandomMap(random, mirrors: false)), (1, RandomMap(random, mirrors: false)), (2, RandomMap(random, mirrors: false))]);
            Motion motion = i % 2 == 0 ? inner : Motion.Between([(0.5, RandomMap(random, mirrors: false)), (1.5, RandomMap(random, mirrors: false))]) * inner;
            Vector3 corner = RandomVector(random);
            Bounds box = new Bounds(corner, corner).Union(new(RandomVector(random), RandomVector(random)));
            box = new(Vector3.Min(box.Minimum, box.Maximum), Vector3.Max(box.Minimum, box.Maximum));
            (double open, double close) = (random.NextDouble() - 0.2, 1 + (1.5 * random.NextDouble()));
            Bounds all = motion.Bound(box, open, close);
            for (int sample = 0; sample < 300; sample++)
            {
                Vector3 p = new(Mix(random, box.Minimum.X, box.Maximum.X), Mix(random, box.Minimum.Y, box.Maximum.Y), Mix(random, box.Minimum.Z, box.Maximum.Z));
                Vector3 q = motion.At(open + ((close - open) * random.NextDouble())).Point(p);
                Assert.True(q == Vector3.Clamp(q, all.Minimum, all.Maximum), $"{q} is outside of {all}");
            }
        }
    }

    private static float Mix(Random random, float a, float b) => random.Next(3) switch { 0 => a, 1 => b, _ => a + (random.NextSingle() * (b - a)) };

    private static void AssertClose(in Transform expected, in Transform actual, double tolerance)
    {
        foreach (Vector3 p in new Vector3[] { Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ })
        {
            Assert.True((expected.Point(p) - actual.Point(p)).Norm() <= tolerance * 10, $"{p} goes to {actual.Point(p)}, not {expected.Point(p)}");
        }
    }

    private static Vector3 RandomVector(Random random) => new((random.NextSingle() - 0.5f) * 4, (random.NextSingle() - 0.5f) * 4, (random.NextSingle() - 0.5f) * 4);

    private static Transform RandomMap(Random random, bool mirrors = true)
    {
        Vector3 scale = new(0.3f + random.NextSingle(), 0.3f + random.NextSingle(), 0.3f + random.NextSingle());
        scale.X *= mirrors && random.Next(2) == 0 ? -1 : 1;
        return Transform.Translation(RandomVector(random)) * Transform.Rotation(RandomVector(random), random.NextSingle() * 720)
            * Transform.Scaling(scale) * Transform.Rotation(RandomVector(random), random.NextSingle() * 360);
    }
}
