using System.Numerics;
using RayTracer.Cameras;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Tests.Cameras;

public class CameraTests
{
    private const int Width = 200;
    private const int Height = 100;
    private static readonly Vector3 s_eye = new(1, 2, 3);
    private static readonly CameraDescription s_forward = new() { Position = s_eye, LookAt = s_eye - (4 * Vector3.UnitZ) };

    [Theory]
    [InlineData(FieldOfViewAxis.Vertical, 100, 0)]
    [InlineData(FieldOfViewAxis.Horizontal, 0, 50)]
    [InlineData(FieldOfViewAxis.Smaller, 100, 0)]
    [InlineData(FieldOfViewAxis.Larger, 0, 50)]
    [InlineData(FieldOfViewAxis.Diagonal, 0, 0)]
    public void Field_of_view_is_measured_over_its_axis(FieldOfViewAxis axis, float x, float y)
    {
        Camera camera = Create(s_forward with { FieldOfView = 70, FieldOfViewAxis = axis });
        (_, Vector3 direction) = Ray(camera, x, y);
        Assert.Equal(Math.Cos(35 * Math.PI / 180), -direction.Z, 1e-6);
    }

    [Theory]
    [InlineData(FieldOfViewAxis.Vertical, 6)]
    [InlineData(FieldOfViewAxis.Horizontal, 12)]
    public void Orthographic_rays_are_parallel_and_as_far_apart_as_the_view_size_says(FieldOfViewAxis axis, float size)
    {
        Camera camera = Create(s_forward with { Projection = Projection.Orthographic, ViewSize = size, FieldOfViewAxis = axis });
        foreach ((float x, float y, Vector3 offset) in new[] { (100f, 50f, Vector3.Zero), (0f, 0f, new Vector3(-6, 3, 0)), (200f, 75f, new Vector3(6, -1.5f, 0)) })
        {
            (Vector3 origin, Vector3 direction) = Ray(camera, x, y);
            Assert.True((origin - s_eye - offset).Norm() < 1e-5f, $"{x}, {y}: {origin}");
            Assert.Equal(-Vector3.UnitZ, direction);
        }
    }

    [Theory]
    [InlineData(100, 50, 0, 0, -1)]
    [InlineData(150, 50, 1, 0, 0)]
    [InlineData(50, 50, -1, 0, 0)]
    [InlineData(0, 50, 0, 0, 1)]
    [InlineData(200, 50, 0, 0, 1)]
    [InlineData(37, 0, 0, 1, 0)]
    [InlineData(160, 100, 0, -1, 0)]
    [InlineData(100, 25, 0, 0.70710678f, -0.70710678f)]
    [InlineData(100, -25, 0, 0.70710678f, 0.70710678f)]
    public void Spherical_picture_shows_longitude_across_and_latitude_along_its_height(float x, float y, float dx, float dy, float dz)
    {
        (Vector3 origin, Vector3 direction) = Ray(Create(s_forward with { Projection = Projection.Spherical }), x, y);
        Assert.Equal(s_eye, origin);
        Assert.True((direction - new Vector3(dx, dy, dz)).Norm() < 1e-6f, $"{direction}");
    }

    [Theory]
    [InlineData("perspective", LensShape.Bladed)]
    [InlineData("orthographic", LensShape.Bladed)]
    [InlineData("perspective", LensShape.Disk)]
    [InlineData("orthographic", LensShape.Square)]
    public void Rays_through_all_of_a_lens_meet_in_the_plane_in_focus(string projection, LensShape shape)
    {
        LensDescription lens = new() { Shape = shape, ApertureRadius = 0.5f, FocusDistance = 2, Blades = 5, Rotation = 30 };
        Camera camera = Create(s_forward with { Projection = Projection.Known.Find(projection)!, Lens = lens });
        (Vector3 middle, Vector3 towards) = Ray(camera, 30, 80);
        Vector3 focus = middle + (towards * (2 / -towards.Z));
        IndependentSampler sampler = new(64);
        camera.GenerateRays(30f, 80f, sampler, 5u, UIntW.Iota, out Vec3W origin, out Vec3W direction);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Vector3 start = new(origin.X[lane], origin.Y[lane], origin.Z[lane]);
            Vector3 along = new(direction.X[lane], direction.Y[lane], direction.Z[lane]);
            Assert.InRange((start - middle).Norm(), 1e-3f, shape == LensShape.Square ? 0.7072f : 0.5001f);
            Assert.Equal(s_eye.Z, start.Z, 1e-6f);
            Assert.True((start + (along * (2 / -along.Z)) - focus).Norm() < 2e-6f);
        }
    }

    [Theory]
    [InlineData("perspective")]
    [InlineData("orthographic")]
    [InlineData("spherical")]
    public void What_is_picked_is_what_the_picture_shows(string projection)
    {
        Scene scene = TestScenes.Build($$"""
            {
              "camera": { "projection": "{{projection}}", "position": [0, 0, 5], "lookAt": [0, 0, 0], "viewSize": 4 },
              "render": { "integrator": "report", "width": 48, "height": 24, "samplesPerPixel": 1, "sampler": "regular" },
              "shapes": [{ "type": "sphere", "center": [0.7, 0.3, 0], "material": { "type": "luminaire" } }]
            }
            """);
        Film film = new RTracer(scene).Render().Film;
        SurfaceProbe probe = new(scene);
        int seen = 0;
        for (int y = 0; y < film.Height; y++)
        {
            for (int x = 0; x < film.Width; x++)
            {
                bool isSeen = probe.Describe(x + 0.5f, y + 0.5f) is not null;
                Assert.Equal(isSeen ? Rgb.White : Rgb.Black, film.Mean(x, y));
                seen += isSeen ? 1 : 0;
            }
        }

        Assert.InRange(seen, 5, 600);
    }

    [Fact]
    public void A_camera_can_be_moved_whatever_it_is()
    {
        foreach (Projection projection in Projection.Known.All)
        {
            CameraDescription still = s_forward with { Projection = projection };
            (Vector3 origin, Vector3 direction) = Ray(Create(still), 130, 20);
            (Vector3 moved, Vector3 turned) = Ray(Create(still with { Transform = [new() { Rotate = 90, Translate = new(0, 7, 0) }] }), 130, 20);
            Assert.True((moved - new Vector3(origin.Z, origin.Y + 7, -origin.X)).Norm() < 1e-5f);
            Assert.True((turned - new Vector3(direction.Z, direction.Y, -direction.X)).Norm() < 1e-6f);
        }
    }

    private static Camera Create(CameraDescription camera)
    {
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        Camera made = Camera.Create(camera, Width, Height, builder)!;
        Assert.Empty(builder.Complaints);
        return made;
    }

    private static (Vector3 Origin, Vector3 Direction) Ray(Camera camera, float x, float y)
    {
        camera.CentralRay(x, y, 0, out Vec3W origin, out Vec3W direction);
        return (new(origin.X[0], origin.Y[0], origin.Z[0]), new(direction.X[0], direction.Y[0], direction.Z[0]));
    }
}
