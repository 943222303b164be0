using System.Numerics;
using RayTracer.Cameras;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Testing;

namespace RayTracer.Tests.Cameras;

/// <summary>Connections of a <see cref="Camera"/> with points of the scene.</summary>
public class CameraLinkTests
{
    private const int Width = 200;
    private const int Height = 100;
    private const uint Key = 17;
    private static readonly IndependentSampler s_sampler = new(1 << 16);
    private static readonly CameraDescription s_plain = new() { Position = new(1, 2, 3), LookAt = new(0.5f, 1.4f, -1), FieldOfView = 50, ViewSize = 6 };
    private static readonly LensDescription s_lens = new() { ApertureRadius = 0.4f, FocusDistance = 2.5f, Blades = 5, Rotation = 30 };
    private static readonly Dictionary<string, CameraDescription> s_cameras = new()
    {
        ["pinhole"] = s_plain,
        ["window"] = s_plain with { Window = [0.5f, 0.1f, 0.25f, 0.4f], FieldOfViewAxis = FieldOfViewAxis.Diagonal },
        ["disk"] = s_plain with { Lens = s_lens },
        ["bladed window"] = s_plain with { Lens = s_lens with { Shape = LensShape.Bladed }, Window = [0.5f, 0.1f, 0.25f, 0.4f] },
        ["moved eye"] = s_plain with { Lens = new() { Shape = LensShape.EyeJitter, Jitter = new(0.5f, 0.3f, 0.9f) } },
        ["parallel"] = s_plain with { Projection = Projection.Orthographic },
        ["parallel square"] = s_plain with { Projection = Projection.Orthographic, Lens = s_lens with { Shape = LensShape.Square } },
        ["parallel moved eye"] = s_plain with { Projection = Projection.Orthographic, Lens = new() { Shape = LensShape.EyeJitter, Jitter = new(0.5f, 0.3f, 0.9f) } },
        ["spherical"] = s_plain with { Projection = Projection.Spherical },
    };

    private static readonly Dictionary<string, Func<CameraDescription, CameraDescription>> s_places = new()
    {
        ["where it is"] = c => c,
        ["stretched and mirrored"] = c => c with { Transform = [new() { Rotate = 40, Axis = new(1, 2, 0) }, new() { Scale = new(1.5f, 0.7f, -1.2f), Translate = new(0, 1, 0) }] },
        ["moving"] = c => c with
        {
            Motion =
            [
                new() { Time = 0, Transform = [new() { Translate = new(1, 0, 0) }] },
                new() { Time = 1, Transform = [new() { Scale = new(2.5f), Rotate = 70, Translate = new(-1, 3, 0) }] },
            ],
        },
    };

    public static IEnumerable<object[]> Cases => s_cameras.Keys.SelectMany(c => s_places.Keys.Select(p => new object[] { c, p }));

    [Theory]
    [MemberData(nameof(Cases))]
    public void The_ray_through_where_a_point_is_seen_passes_the_point(string camera, string place)
    {
        Camera made = Create(camera, place);
        int seen = 0;
        for (uint round = 0; round < 16; round++)
        {
            // Points that rays through other points of the lens pass.
            RayPacket to = new(made, round, Key + 1);
            FloatW distance = FloatW.MultiplyAdd(to.Random, 6f, 2f);
            Vec3W point = Vec3W.MultiplyAdd(to.Direction, distance, to.Origin);
            made.Link(point, to.Time, s_sampler, Key, to.Sample, out CameraLinkW link);
            made.GenerateRays(link.X, link.Y, s_sampler, Key, to.Sample, out Vec3W origin, out Vec3W direction);
            made.Place(to.Time, ref origin, ref direction);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                if ((link.Sees.Bits >> lane & 1) == 0)
                {
                    continue;
                }

                Vector3D start = Vector3D.Of(origin, lane);
                Vector3D along = Vector3D.Of(direction, lane);
                Vector3D offset = Vector3D.Of(point, lane) - start;
                Assert.True((offset - (along * offset.Length)).Length < 2e-5, $"{offset} and {along}");
                Assert.True((Vector3D.Of(link.Direction, lane) + along).Length < 1e-5);
                Assert.Equal(offset.Length, link.Distance[lane], 2e-5);
                seen++;
            }
        }

        Assert.True(seen > 8 * FloatW.Count, $"{seen}");
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Density_is_the_reciprocal_of_the_area_between_the_rays_of_neighbouring_pixels(string camera, string place)
    {
        const float step = 0.5f;
        Camera made = Create(camera, place);
        for (uint round = 0; round < 8; round++)
        {
            RayPacket to = new(made, round, Key);
            FloatW distance = FloatW.MultiplyAdd(to.Random, 6f, 2f);
            Vec3W point = Vec3W.MultiplyAdd(to.Direction, distance, to.Origin);
            made.Density(to.Origin, to.Direction, distance, to.Time, out FloatW density);
            made.Link(point, to.Time, s_sampler, Key, to.Sample, out CameraLinkW link);
            Vec3W[] around = [.. new (float X, float Y)[] { (-step, 0), (step, 0), (0, -step), (0, step) }.Select(s => to.Meet(made, s.X, s.Y, Key, point))];
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Vector3D acrossX = Vector3D.Of(around[1], lane) - Vector3D.Of(around[0], lane);
                Vector3D acrossY = Vector3D.Of(around[3], lane) - Vector3D.Of(around[2], lane);
                double expected = 4 * step * step / acrossX.Cross(acrossY).Length;
                Assert.Equal(1, density[lane] / expected, 2e-3);
                Assert.Equal(1, link.Density[lane] / density[lane], 1e-4);
                Assert.Equal(to.X[lane], link.X[lane], 5e-3f);
                Assert.Equal(to.Y[lane], link.Y[lane], 5e-3f);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Points_of_a_plane_make_up_the_pixels_that_show_it(string camera, string place)
    {
        const int count = 96;
        Camera made = Create(camera, place);

        // A rectangle of which the middle of a side lies within the picture, and the rest in part beyond.
        made.CentralRay(0.8f * Width, 0.6f * Height, 0.6f, out Vec3W origin, out Vec3W direction);
        Vector3D right = Vector3D.Of(origin) + (Vector3D.Of(direction) * 4);
        made.CentralRay(0.4f * Width, 0.6f * Height, 0.6f, out origin, out direction);
        Vector3D side = Vector3D.Of(origin) + (Vector3D.Of(direction) * 4);
        Vector3D normal = (Vector3D.Of(direction) + new Vector3D(0.3, -0.2, 0.25)).Unit;
        Vector3D u = normal.Cross(new(0.3, 1, 0.2)).Unit * (2 * (right - side).Length);
        Vector3D v = normal.Cross(u) * 0.4;
        Vector3D middle = side + (u * 0.5);
        double area = u.Cross(v).Length;
        double sum = 0;
        double shown = 0;
        for (int i = 0; i < count * count; i += FloatW.Count)
        {
            UIntW number = UIntW.Iota + (uint)i;
            Numbers(3, number, out FloatW a, out FloatW b);
            FloatW row = FloatW.Floor((number.ToFloat() + 0.5f) / count);
            FloatW s = ((number.ToFloat() - (row * count) + a) / count) - 0.5f;
            FloatW t = ((row + b) / count) - 0.5f;
            Vec3W point = Vec3W.MultiplyAdd((Vector3)u, s, Vec3W.MultiplyAdd((Vector3)v, t, (Vector3)middle));
            made.Link(point, 0.6f, s_sampler, Key, number, out CameraLinkW link);
            FloatW rays = link.Sees.Select(link.Density * FloatW.Abs(Vec3W.Dot(link.Direction, (Vector3)normal)), 0f);

            made.GenerateRays((s + 0.5f) * Width, (t + 0.5f) * Height, s_sampler, Key + 1, number, out origin, out direction);
            made.Place(0.6f, ref origin, ref direction);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                sum += rays[lane] * area;
                Vector3D start = Vector3D.Of(origin, lane) - middle;
                Vector3D along = Vector3D.Of(direction, lane);
                double distance = -start.Dot(normal) / along.Dot(normal);
                Vector3D met = start + (along * distance);
                bool isMet = distance > 0 && Math.Abs(met.Dot(u)) < 0.5 * u.Squared && Math.Abs(met.Dot(v)) < 0.5 * v.Squared;
                shown += isMet ? Width * Height : 0;
            }
        }

        Assert.InRange(shown / (count * count), 300, 17000);
        Assert.Equal(1, sum / shown, 0.025);
    }

    [Theory]
    [InlineData("pinhole")]
    [InlineData("parallel square")]
    public void What_lies_behind_or_beside_is_not_seen(string camera)
    {
        foreach ((float x, float distance, float margin, bool isSeen) in new[]
            {
                (50f, 3f, 0f, true), (50f, -3f, 0f, false), (-1f, 3f, 0f, false), (-1f, 3f, 1.5f, true), (-2f, 3f, 1.5f, false), (201.4f, 3f, 1.5f, true), (201.6f, 3f, 1.5f, false),
            })
        {
            Camera made = Create(s_cameras[camera], margin);
            made.GenerateRays(x, 30f, s_sampler, Key, UIntW.Iota, out Vec3W origin, out Vec3W direction);
            made.Link(Vec3W.MultiplyAdd(direction, distance, origin), 0f, s_sampler, Key, UIntW.Iota, out CameraLinkW link);
            Assert.Equal(isSeen ? MaskW.All.Bits : 0, link.Sees.Bits);
        }
    }

    [Fact]
    public void Only_invertible_projections_link()
    {
        Assert.All(s_cameras.Values, c => Assert.True(Create(c).CanLink));
        Assert.False(Create(s_plain with { Projection = new OneWay() }).CanLink);
    }

    [Theory]
    [InlineData(6, 3)]
    [InlineData(5, 3)]
    public void Around_a_sphere_filters_reach_over_the_poles_and_the_edge(int width, int height)
    {
        // Each pixel by its own samples, and by points that are the same everywhere in the picture.
        const int count = 1 << 16;
        Camera camera = Create(s_cameras["spherical"], 0, width, height);
        var filter = PixelFilter.Create(new() { Shape = FilterShape.Tent, Radius = 1.25f });
        double[] splats = new double[width * height];
        double[] means = new double[width * height];
        for (uint i = 0; i < count; i += (uint)FloatW.Count)
        {
            UIntW number = UIntW.Iota + i;
            Numbers(1, number, out FloatW x, out FloatW y);
            Numbers(2, number, out FloatW u, out FloatW v);
            Assert.Equal(MaskW.All.Bits, camera.Splat(filter, x * width, y * height, u, v, out FloatW pixelX, out FloatW pixelY, out FloatW weight).Bits);
            FloatW seen = weight * Seen(camera, x * width, y * height);
            FloatW row = FloatW.Floor(number.ToFloat() * (1f / width)) - (FloatW.Floor(number.ToFloat() * (1f / (width * height))) * height);
            FloatW column = number.ToFloat() - (FloatW.Floor(number.ToFloat() * (1f / width)) * width);
            filter!.Place(ref u, ref v);
            FloatW own = Seen(camera, column + u, row + v);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                splats[((int)pixelY[lane] * width) + (int)pixelX[lane]] += seen[lane] * width * height / count;
                means[((int)(i + lane)) % (width * height)] += own[lane] * width * height / count;
            }
        }

        for (int i = 0; i < means.Length; i++)
        {
            Assert.Equal(1, splats[i] / means[i], 0.06);
        }
    }

    private static FloatW Seen(Camera camera, FloatW x, FloatW y)
    {
        camera.GenerateRays(x, y, s_sampler, Key, 0u, out _, out Vec3W direction);
        return FloatW.MultiplyAdd(direction.X, 0.6f, FloatW.MultiplyAdd(direction.Y, 0.3f, 1f));
    }

    private static void Numbers(uint set, UIntW sample, out FloatW u, out FloatW v)
    {
        s_sampler.Begin(set, sample, 7u, out SamplePoints points);
        s_sampler.Pair(points, 0, out u, out v);
    }

    private static Camera Create(string camera, string place) => Create(s_places[place](s_cameras[camera]));

    private static Camera Create(CameraDescription camera, float margin = 0, int width = Width, int height = Height)
    {
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        Camera made = Camera.Create(camera, width, height, builder, margin)!;
        Assert.Empty(builder.Complaints);
        return made;
    }

    // Rays through random points of the picture, not too near to the edges, at random times.
    private sealed class RayPacket
    {
        public RayPacket(Camera camera, uint round, uint key)
        {
            Sample = UIntW.Iota + (round * 16);
            Numbers(1, Sample, out FloatW u, out FloatW v);
            (X, Y) = (FloatW.MultiplyAdd(u, 0.9f * Width, 0.05f * Width), FloatW.MultiplyAdd(v, 0.8f * Height, 0.1f * Height));
            Numbers(2, Sample, out FloatW time, out FloatW random);
            (Time, Random) = (time, random);
            camera.GenerateRays(X, Y, s_sampler, key, Sample, out Vec3W origin, out Vec3W direction);
            camera.Place(Time, ref origin, ref direction);
            (Origin, Direction) = (origin, direction);
        }

        public UIntW Sample { get; }

        public FloatW X { get; }

        public FloatW Y { get; }

        public FloatW Time { get; }

        public FloatW Random { get; }

        public Vec3W Origin { get; }

        public Vec3W Direction { get; }

        // Where a neighbouring ray meets the plane through a point of this ray, perpendicular to it; relative to that point.
        public Vec3W Meet(Camera camera, float shiftX, float shiftY, uint key, Vec3W point)
        {
            camera.GenerateRays(X + shiftX, Y + shiftY, s_sampler, key, Sample, out Vec3W origin, out Vec3W direction);
            camera.Place(Time, ref origin, ref direction);
            FloatW distance = Vec3W.Dot(point - origin, Direction) / Vec3W.Dot(direction, Direction);
            return Vec3W.MultiplyAdd(direction, distance, origin - point);
        }
    }

    private sealed class OneWay() : Projection("oneWay")
    {
        public override float HeightAt(CameraDescription camera, float distance, float aspect) => distance;

        public override CameraDescription? Zoomed(CameraDescription camera, float factor) => null;

        public override CameraProjection Create(in CameraView view) => new Straight(view.Camera.Position, view.Forward);

        private sealed class Straight(Vector3 eye, Vector3 forward) : CameraProjection
        {
            public override void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus) => (origin, toFocus) = (eye, forward);
        }
    }
}
