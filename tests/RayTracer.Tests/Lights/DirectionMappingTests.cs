using System.Numerics;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Tests.Lights;

/// <summary>Covers `DirectionMap`, `PictureSphere`.</summary>
public class DirectionMappingTests
{
    [Theory]
    [InlineData(0, 1, 0, 0.5, 0.5)]
    [InlineData(1, 0, 0, 1, 0.5)]
    [InlineData(0, 0, 1, 0.5, 1)]
    [InlineData(0, 0, -1, 0.5, 0)]
    [InlineData(-1, 0, 0, 0, 0.5)]
    [InlineData(0.001, -1, 0.001, 1, 1)]
    public void The_middle_of_an_octahedral_picture_is_up_and_its_corners_are_down(double x, double y, double z, double u, double v)
    {
        DirectionMap.Find(DirectionMapping.Octahedral, Vec3W.Normalize(new((float)x, (float)y, (float)z)), out FloatW atU, out FloatW atV);
        Assert.Equal(u, atU[0], 2e-3);
        Assert.Equal(v, atV[0], 2e-3);
    }

    [Theory]
    [InlineData(0.001, 0, -1, 0)]
    [InlineData(1, 0, 0, 0.25)]
    [InlineData(0.001, 0, 1, 0.5)]
    [InlineData(-1, 0, 0, 0.75)]
    public void By_longitude_the_middle_is_towards_z_and_the_left_towards_x_as_in_an_environment(float x, float y, float z, double u)
    {
        DirectionMap.Find(DirectionMapping.LatitudeLongitude, Vec3W.Normalize(new(x, y, z)), out FloatW atU, out FloatW atV);
        Assert.Equal(u, atU[0], 1e-3);
        Assert.Equal(0.5, atV[0], 1e-6);
    }

    [Theory]
    [InlineData(DirectionMapping.Octahedral)]
    [InlineData(DirectionMapping.LatitudeLongitude)]
    public void Areas_of_the_square_are_kept_by_the_octahedron(DirectionMapping mapping)
    {
        // Of directions spread evenly over the sphere, as many are in each of 8×8 fields, or by the cosine of the latitude.
        const int side = 400;
        int[] found = new int[64];
        for (int i = 0; i < side * side; i++)
        {
            double y = ((2 * ((i / side) + 0.5)) / side) - 1;
            double turn = 2 * Math.PI * (((i % side) + 0.25) / side);
            double r = Math.Sqrt(1 - (y * y));
            DirectionMap.Find(mapping, new Vec3W((float)(r * Math.Cos(turn)), (float)y, (float)(r * Math.Sin(turn))), out FloatW u, out FloatW v);
            found[(8 * Math.Min((int)(v[0] * 8), 7)) + Math.Min((int)(u[0] * 8), 7)]++;
        }

        for (int i = 0; i < 64; i++)
        {
            double rows = mapping == DirectionMapping.Octahedral ? 1.0 / 8 : (Math.Cos(Math.PI * (i / 8) / 8) - Math.Cos(Math.PI * ((i / 8) + 1) / 8)) / 2;
            Assert.Equal(side * side * rows / 8, found[i], side * side * 0.0012);
        }
    }

    // A picture that shows a smooth function of the direction, as an environment and around a light.
    [Fact]
    public void An_octahedral_picture_is_seen_in_its_directions()
    {
        const int side = 256;
        Picture square = new(side, side);
        foreach (Vector3 d in Directions(200_000))
        {
            DirectionMap.Find(DirectionMapping.Octahedral, d, out FloatW u, out FloatW v);
            int texel = 3 * ((Math.Min((int)((1 - v[0]) * side), side - 1) * side) + Math.Min((int)(u[0] * side), side - 1));
            (square.Pixels[texel], square.Pixels[texel + 1], square.Pixels[texel + 2]) = (1 + d.X, 1 + d.Y, 1 + d.Z);
        }

        EnvironmentLight environment = new ImageEnvironmentDescription { Picture = square, Mapping = DirectionMapping.Octahedral }.Build(new())!;
        PointLightDescription description = new() { Picture = new ImageTextureDescription { Picture = square, Wrapping = Wrapping.Clamp }, Mapping = DirectionMapping.Octahedral };
        LightSource light = description.Create(Motion.None, description.BuildPicture(new()));
        foreach (Vector3 d in Directions(500))
        {
            environment.Evaluate(d, out RgbW seen);
            light.Sample(d, 0f, 0f, 0f, out ShapeSampleW _, out RgbW thrown);
            foreach (RgbW color in new[] { seen, thrown })
            {
                Assert.Equal(1 + d.X, color.R[0], 0.03);
                Assert.Equal(1 + d.Y, color.G[0], 0.03);
                Assert.Equal(1 + d.Z, color.B[0], 0.03);
            }
        }
    }

    // One bright pixel of 64×64 is 4π/64² of the sphere.
    [Theory]
    [InlineData(20, 30)]
    [InlineData(32, 32)]
    [InlineData(0, 0)]
    public void A_bright_pixel_sends_as_much_light_after_it_is_unfolded(int x, int y)
    {
        Picture square = new(64, 64);
        square.Pixels[3 * ((64 * y) + x) + 1] = 1000;
        Picture unfolded = DirectionMap.Unfolded(square);
        ImageEnvironment environment = new(unfolded, 1, Transform.Identity);
        double all = Directions(200_000).Average(d =>
        {
            environment.Evaluate(d, out RgbW radiance);
            return radiance.G[0];
        });
        Assert.Equal(1000.0 / (64 * 64), all, 0.15 * 1000 / (64 * 64));
    }

    private static IEnumerable<Vector3> Directions(int count)
    {
        for (int i = 0; i < count; i++)
        {
            double y = 1 - ((2 * (i + 0.5)) / count);
            double turn = Math.PI * (3 - Math.Sqrt(5)) * i;
            double r = Math.Sqrt(1 - (y * y));
            yield return new((float)(r * Math.Cos(turn)), (float)y, (float)(r * Math.Sin(turn)));
        }
    }
}
