using System.Globalization;
using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Tests.Lights;

/// <summary>
/// Rays that leave lights, against the samples that lit points take of the same lights: a sphere around a light, or inside of one that is infinitely
/// far away, is met by as many rays, and by as much power, as its points say.
/// Covers `LightEmission`, `LightSource`, `SceneBall`.
/// </summary>
public class EmissionTests
{
    private const int Rays = 1 << 15;
    private const int Rings = 8, Sectors = 8;

    // Lit points along each side of a cell.
    private const int Side = 9;
    private const float NearRadius = 3, FarRadius = 1.5f;

    // Of the far lights' scenes: a sphere of radius 2 in a cube, in a ball with a little more.
    private const double DiskArea = Math.PI * 12 * 1.0002;
    private const string Turned = """ "transform": [{ "scale": [1.3, -0.4, 0.7], "rotate": 33, "axis": [1, 2, 3], "translate": [0.2, 0.4, -0.3] }] """;
    private const string Moving = """ "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "scale": [0.5, 1.5, 1], "rotate": 70, "axis": [1, 0, 1], "translate": [0.5, 0.2, 0] }] }] """;
    private const string Mesh = """ "type": "mesh", "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0.2], [1, 0.2, 1.4]], "triangles": [[0, 1, 2], [1, 3, 2]] """;

    private static readonly LuminaireMaterial s_luminaire = new(new UvTexture(), 1, 0, null);

    // Each light, and its power of green where that is known.
    private static readonly Dictionary<string, (string Json, double? Power)> s_cases = new()
    {
        ["sphere"] = ("""{ "type": "sphere", "center": [0.1, 0.2, 0], "radius": 0.5, SHINES }""", 2 * Math.PI * Math.PI),
        ["sphere with a lobe"] = ("""{ "type": "sphere", "center": [0.1, 0.2, 0], "radius": 0.5, SPOTS }""", 2 * 2 * Math.PI / 5.5 * Math.PI),
        ["plane"] = ("""{ "type": "plane", "point": [0.1, 0.2, 0], "normal": [0.3, 1, 0.2], "size": [1, 2], SPOTS }""", 2 * 2 * Math.PI / 5.5 * 2),
        ["plane with a picture"] = ("""{ "type": "plane", "point": [0.1, 0.2, 0], "normal": [0.3, 1, 0.2], "size": [1, 2], "material": { "type": "luminaire", "color": { "type": "checker", "scale": [2, 2], "even": [1, 2, 3], "odd": [0.1, 0.2, 0.3] } } }""", Math.PI * 2 * 1.1),
        ["rectangle"] = ("""{ "type": "rectangle", "corner": [-0.5, 0, 0.5], "edgeU": [1, 0.3, 0.5], "edgeV": [0.4, 0.2, -1], SHINES }""", null),
        ["triangle"] = ("""{ "type": "triangle", "a": [-1, 0, 1], "b": [1, 0.3, 1], "c": [0.1, 0.2, -1.5], SHINES }""", null),
        ["disk"] = ("""{ "type": "disk", "center": [0.1, 0.2, -0.3], "normal": [0.2, 1, 0.3], "radius": 1.3, SPOTS }""", 2 * 2 * Math.PI / 5.5 * Math.PI * 1.69),
        ["box"] = ("""{ "type": "box", "a": [-0.8, 0.6, 0.8], "b": [0.9, -0.5, -0.7], SHINES }""", 4 * Math.PI * ((1.7 * 1.1) + (1.1 * 1.5) + (1.5 * 1.7))),
        ["turned box"] = ("""{ "type": "group", "shapes": [{ "type": "box", "a": [-0.8, 0.6, 0.8], "b": [0.9, -0.5, -0.7], SHINES }], "transform": [{ "rotate": 33, "axis": [1, 2, 3] }] }""", 4 * Math.PI * ((1.7 * 1.1) + (1.1 * 1.5) + (1.5 * 1.7))),
        ["cylinder"] = ("""{ "type": "cylinder", "bottom": [0, 0, 0], "top": [0, 1, 0.3], "radius": 0.5, SHINES }""", null),
        ["frustum"] = ("""{ "type": "cone", "bottom": [0, -0.6, 0.1], "top": [0.3, 0.7, 0], "radius": 0.5, "topRadius": 0.9, SHINES }""", null),
        ["torus"] = ("""{ "type": "torus", "center": [0.1, -0.1, 0.2], "axis": [0.8, 1, 0.4], "radius": 1.1, "tubeRadius": 0.35, SHINES }""", 2 * Math.PI * 4 * Math.PI * Math.PI * 1.1 * 0.35),
        ["mesh"] = ("{ MESH, SHINES }", null),
        ["mesh in an instance"] = ("""{ "type": "instance", "of": { MESH, SPOTS }, TURNED }""", null),
        ["moving mesh"] = ("""{ "type": "instance", "of": { MESH, SHINES }, MOVING }""", null),
        ["ellipsoid"] = ("""{ "type": "instance", "of": { "type": "sphere", "center": [0.1, 0, 0], "radius": 0.9, SPOTS }, TURNED }""", null),
        ["cone in an instance"] = ("""{ "type": "instance", "of": { "type": "cone", "bottom": [0, 0, 0], "top": [0, 1, 0], "radius": 0.8, SHINES }, TURNED }""", null),
        ["moving torus"] = ("""{ "type": "instance", "of": { "type": "torus", "center": [0, 0, 0.1], "axis": [0.8, 1, 0.4], "radius": 0.8, "tubeRadius": 0.35, SHINES }, MOVING }""", null),
        ["point"] = ("""{ "type": "point", "position": [0.3, 0.2, 1], "intensity": [1, 2, 3] }""", 8 * Math.PI),
        ["moving point"] = ("""{ "type": "group", "shapes": [{ "type": "point", "position": [0.3, 0.2, 1], "intensity": [1, 2, 3] }], MOVING }""", 8 * Math.PI),
        ["point with a picture"] = ("""{ "type": "point", "position": [0.3, 0.2, 1], "intensity": [1, 2, 3], "picture": { "type": "checker", "scale": [4, 2], "even": [1, 1, 1], "odd": [0.2, 0.2, 0.2] } }""", 8 * Math.PI * 0.6),
        ["turning point with a picture"] = ("""{ "type": "group", "shapes": [{ "type": "point", "intensity": [1, 2, 3], "mapping": "octahedral", "picture": { "type": "checker", "scale": [4, 2], "even": [1, 1, 1], "odd": [0.2, 0.2, 0.2] } }], MOVING }""", 8 * Math.PI * 0.6),
        ["spot"] = ("""{ "type": "spot", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "cutoffAngle": 60, "beamWidth": 20 }""", Spot(60, 20, false)),
        ["smooth spot"] = ("""{ "type": "spot", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "cutoffAngle": 60, "beamWidth": 20, "falloff": "smooth" }""", Spot(60, 20, true)),
        ["sharp spot"] = ("""{ "type": "spot", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "cutoffAngle": 40, "beamWidth": 40 }""", Spot(40, 40, false)),
        ["wide spot"] = ("""{ "type": "spot", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "cutoffAngle": 180, "beamWidth": 0 }""", Spot(180, 0, false)),
        ["moving spot"] = ("""{ "type": "group", "shapes": [{ "type": "spot", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "cutoffAngle": 60, "beamWidth": 0 }], MOVING }""", Spot(60, 0, false)),
        ["spot with a picture"] = ("""{ "type": "spot", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "cutoffAngle": 60, "beamWidth": 20, "picture": { "type": "checker", "scale": [2, 2], "even": [1, 1, 1], "odd": [0.3, 0.3, 0.3] } }""", null),
        ["projector"] = ("""{ "type": "projector", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "fieldOfView": 90, "aspect": 2 }""", 2 * 2),
        ["moving projector"] = ("""{ "type": "group", "shapes": [{ "type": "projector", "position": [0.3, 0.2, 1], "direction": [1, -2, 0.5], "intensity": [1, 2, 3], "fieldOfView": 90, "evenOnWalls": false }], MOVING }""", null),
        ["directional"] = ("""{ "type": "directional", "direction": [1, -2, 0.5], "irradiance": [1, 2, 3] }""", 2 * DiskArea),
        ["turning directional"] = ("""{ "type": "group", "shapes": [{ "type": "directional", "direction": [1, -2, 0.5], "irradiance": [1, 2, 3] }], MOVING }""", 2 * DiskArea),
        ["constant environment"] = ("""{ "type": "constant", "radiance": [1, 2, 3] }""", 8 * Math.PI * DiskArea),
        ["sky"] = ("""{ "type": "sky", "sunSize": 60, "sunElevation": 50, "transform": [{ "rotate": 50, "axis": [1, 2, 0.5] }] }""", null),
        ["sky without a sun"] = ("""{ "type": "sky", "sunScale": 0, "sunElevation": 50 }""", null),
    };

    public static TheoryData<string> Cases => [.. s_cases.Keys];

    [Theory]
    [MemberData(nameof(Cases))]
    public void As_many_rays_and_as_much_power_arrive_as_lit_points_expect(string name)
    {
        (Scene scene, LightSource light) = Build(name);
        Cells expected = Expect(light);
        Cells found = new();
        double all = 0;
        Trace(scene, Rays, (in EmittedW ray, in FloatW _, int lane) =>
        {
            Assert.True(Bit(ray.Exists, lane), "a light shines everywhere");
            all += ray.Power.G[lane] / Rays;
            if (Meet(ray, lane, IsFar(light)) is { } normal)
            {
                found.Add(CellOf(normal), 1, ray.Power.G[lane]);
            }
        });
        Assert.InRange(expected.Counts.Sum(), IsFar(light) ? 0.01 : 0.98, IsFar(light) ? 0.99 : 1.02);
        ErrorBudget.Lights.Check(Cells.Compare(found.Counts, found.Counts, expected.Counts, expected.CountSquares), $"rays from {name}", () => Columns(found.Counts, expected.Counts));
        ErrorBudget.Lights.Check(Cells.Compare(found.Power, found.PowerSquares, expected.Power, expected.PowerSquares), $"power of {name}", () => Columns(found.Power, expected.Power));
        double power = s_cases[name].Power ?? (IsFar(light) ? all : expected.Power.Sum());
        Assert.Equal(power, all, 0.015 * power);

        // By which lights are chosen: about right for what moves or is stretched.
        float estimate = light.EmittedPower((0, 1));
        Assert.InRange(estimate, 0.3 * all, 3 * all);
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void The_densities_of_a_ray_are_the_same_from_where_it_arrives(string name)
    {
        (Scene scene, LightSource light) = Build(name);
        int count = 0, others = 0;
        Trace(scene, 1 << 11, (in EmittedW ray, in FloatW time, int lane) =>
        {
            FloatW distance = IsFar(light) ? 3f : 1f;
            LightHitW hit = new() { From = Vec3W.MultiplyAdd(ray.Direction, distance, ray.Origin), Direction = -ray.Direction, Distance = distance, Cosine = ray.Cosine, Time = time, Primitive = ray.Primitive };
            ShapeSampleW sample = new() { Direction = hit.Direction, Distance = distance, Cosine = ray.Cosine, InversePdf = 1f };
            if (!light.IsDelta && !IsFar(light))
            {
                light.Pdf(hit, out FloatW pdf);
                sample.InversePdf = 1f / pdf;
            }

            light.EmissionPdf(hit, out FloatW point, out FloatW direction);
            light.EmissionPdf(hit.From, sample, time, out FloatW samplePoint, out FloatW sampleDirection);
            double tolerance = 1e-4 + (1e-5 / ray.Cosine[lane]);
            Assert.Equal(1, point[lane] / ray.PointPdf[lane], tolerance);
            Assert.Equal(direction[lane], sampleDirection[lane]);

            // Where the lit point lies inside of a ball that is sampled, no direction has a density.
            Assert.True(Math.Abs((samplePoint[lane] / ray.PointPdf[lane]) - 1) < tolerance || float.IsInfinity(sample.InversePdf[lane]), $"{samplePoint[lane]}, but {ray.PointPdf[lane]}");

            // On the border of two texels, a rounded direction may lie in the other one.
            count++;
            others += Math.Abs((direction[lane] / ray.DirectionPdf[lane]) - 1) < 3 * tolerance + (IsFar(light) || light is SpotLight or ProjectorLight ? 5e-3 : 0) ? 0 : 1;
        });
        Assert.InRange(others, 0, light is EnvironmentLight or SpotLight or ProjectorLight ? count / 200 : 0);
    }

    [Fact]
    public void Nothing_arrives_behind_a_light_or_beside_a_far_ones_disk()
    {
        LightSource plane = Build("plane").Light;
        plane.EmissionPdf(new LightHitW { From = new Vector3(0, -3, 0), Direction = Vector3.UnitY, Distance = 3f, Cosine = -0.5f }, out FloatW point, out FloatW direction);
        Assert.Equal((0, 0), (point[0], direction[0]));
        foreach (string name in new[] { "directional", "constant environment" })
        {
            LightSource light = Build(name).Light;
            Vector3 back = Vector3.Normalize(new(-1, 2, -0.5f));
            foreach ((Vector3 from, bool isCovered) in new (Vector3, bool)[] { (default, true), (back * 3.4f, true), (back * 3.5f, false), (back * -9, true), (Vector3.Normalize(new(2, 1, 0)) * 3.4f, true), (Vector3.Normalize(new(2, 1, 0)) * 3.5f, false) })
            {
                light.EmissionPdf(new LightHitW { From = from, Direction = back, Cosine = 1f }, out point, out direction);
                Assert.Equal(isCovered ? 1 / DiskArea : 0, point[0], 1e-6);
                Assert.True(direction[0] > 0);
            }
        }
    }

    // The plane lies far behind the disks of the light that comes from below; rays start on the sphere's side of it.
    [Theory]
    [InlineData("""{ "type": "plane", "point": [0, -50, 0], "normal": [0, 1, 0] }""", 0)]
    [InlineData("""{ "type": "instance", "of": { "type": "plane", "point": [0, -50, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "checker" } } }, "transform": [{ "scale": [1, 1, 1.3], "rotate": 20, "axis": [0, 1, 0] }] }""", 0)]
    [InlineData("""{ "type": "sphere", "center": [0, 0, 0.3] }""", 1)]
    public void Infinite_surfaces_stop_light_before_it_starts(string shape, int arrives)
    {
        Scene scene = TestScenes.Build($$"""{ "render": { "integrator": "light" }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 2 }, {{shape}}], "environment": { "type": "constant" } }""");
        int seen = 0;
        Trace(scene, 1 << 10, (in EmittedW ray, in FloatW _, int lane) =>
        {
            bool isFromAbove = ray.Direction.Y[lane] < -0.01;
            bool isFromBelow = ray.Direction.Y[lane] > 0.1;
            Assert.True(!isFromAbove || Bit(ray.Exists, lane));
            Assert.True(!isFromBelow || Bit(ray.Exists, lane) == (arrives == 1));
            seen += isFromBelow ? 1 : 0;
        });
        Assert.InRange(seen, 300, 700);
    }

    [Fact]
    public void Where_nothing_has_an_end_no_light_comes_from_afar()
    {
        Scene scene = TestScenes.Build("""{ "render": { "integrator": "light" }, "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }], "environment": { "type": "constant" } }""");
        Trace(scene, 64, (in EmittedW ray, in FloatW _, int lane) => Assert.False(Bit(ray.Exists, lane)));
        Trace(TestScenes.Build("""{ "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }] }"""), 64, (in EmittedW ray, in FloatW _, int lane) => Assert.False(Bit(ray.Exists, lane)));
    }

    [Fact]
    public void Lights_are_chosen_by_power()
    {
        string lamps = string.Join(",\n", Enumerable.Range(0, 3000).Select(i => string.Create(CultureInfo.InvariantCulture, $$"""
            { "type": "point", "position": [{{(i * 7 % 13) - 6}}, 0, 0], "intensity": [0, {{(i == 7 ? 0 : Math.Pow(10, (i % 7) - 4))}}, 0] }
            """)));
        Scene scene = TestScenes.Build($$"""{ "render": { "integrator": "light" }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 0.5, "material": { "type": "luminaire", "color": [0, 900, 0] } }], "lights": [{{lamps}}], "environment": { "type": "constant", "radiance": [0, 20, 0] } }""");
        LightEmission emission = new(scene);
        int lights = scene.SampledLights.Count;
        Assert.Equal(3002, lights);
        double[] probabilities = [.. Enumerable.Range(0, lights).Select(i => (double)emission.Probability((uint)i)[0])];
        double[] powers = [.. scene.SampledLights.Select(l => (double)l.EmittedPower((0, 0)))];
        Assert.Equal(1, probabilities.Sum(), 1e-6);
        for (int i = 0; i < lights; i++)
        {
            Assert.Equal(powers[i] > 0, probabilities[i] > 0);
            Assert.Equal(powers[i] / powers.Sum(), probabilities[i], 4e-4 * probabilities[i] + 2e-7);
        }

        double[] counts = new double[lights];
        double green = 0;
        IndependentSampler sampler = new(Rays);
        for (int i = 0; i < Rays; i += FloatW.Count)
        {
            emission.Start(sampler, 5u, UIntW.Iota + (uint)i, 0f, MaskW.All, out UIntW light, out EmittedW ray);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                counts[(int)light[lane]]++;
                green += ray.Power.G[lane] / Rays;
            }
        }

        ErrorBudget.Lights.Check(PValues.ChiSquared(counts, [.. probabilities.Select(p => p * Rays)]), "lights chosen by power");

        // Power in luminance.
        Assert.Equal(powers.Sum() / 0.7152, green, 1e-2 * green);
    }

    [Fact]
    public void Lanes_that_are_not_in_use_have_no_ray()
    {
        LightEmission emission = new(Build("sphere").Scene);
        emission.Start(new IndependentSampler(16), 1u, UIntW.Iota, 0f, MaskW.First(3), out _, out EmittedW ray);
        Assert.Equal(7u, ray.Exists.Bits);
    }

    [Fact]
    public void A_shape_without_points_to_emit_from_is_refused()
    {
        ShapeBatch batch = new Sphere(s_luminaire, "", default, 1).CreateBatch([new Sphere(s_luminaire, "", default, 1)]);
        Assert.True(new AreaLight(new Sphere(s_luminaire, "", default, 1), 0) { Table = batch }.CanEmit);
        Assert.False(new AreaLight(new PlugIn(s_luminaire), 0) { Table = batch }.CanEmit);
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Rays_start_on_the_light(string name)
    {
        (Scene scene, LightSource light) = Build(name);
        Trace(scene, 256, (in EmittedW ray, in FloatW _, int lane) =>
        {
            Vector3D direction = Vector3D.Of(ray.Direction, lane);
            Assert.Equal(1, direction.Length, 1e-5);
            if (light.IsDelta || IsFar(light))
            {
                Assert.Equal((EmittedW.NoPrimitive, 0u, 1f), (ray.Primitive[lane], ray.Instance[lane], ray.Cosine[lane]));
                return;
            }

            Assert.Equal((uint)light.Instance, ray.Instance[lane]);
            Assert.True(light.Primitive < 0 || ray.Primitive[lane] == (uint)light.Primitive);
            Assert.Equal(direction.Dot(Vector3D.Of(ray.Normal, lane)), ray.Cosine[lane], 1e-5);
            Assert.InRange(ray.Cosine[lane], 1e-6f, 1);
            if (light.Instance > 0 && !scene.IsTimed)
            {
                Transform place = scene.World.Instances!.PlaceOf(light.Instance);
                Vector3 inner = place.Point((Vector3)Vector3D.Of(ray.InnerOrigin, lane));
                Assert.True(((Vector3D)inner - Vector3D.Of(ray.Origin, lane)).Length < 1e-4);
            }
        });
    }

    private static double Spot(double cutoff, double beam, bool isSmooth)
    {
        double sum = 0;
        const int steps = 20000;
        for (int i = 0; i < steps; i++)
        {
            double angle = (i + 0.5) / steps * cutoff;
            double part = beam == cutoff ? 1 : isSmooth ? (Cosine(angle) - Cosine(cutoff)) / (Cosine(beam) - Cosine(cutoff)) : (cutoff - angle) / (cutoff - beam);
            part = Math.Clamp(part, 0, 1);
            sum += (isSmooth ? part * part : part) * Math.Sin(angle * Math.PI / 180) * (cutoff * Math.PI / 180 / steps);
        }

        return 2 * 2 * Math.PI * sum;

        static double Cosine(double degrees) => Math.Cos(degrees * Math.PI / 180);
    }

    private static (Scene Scene, LightSource Light) Build(string name)
    {
        string json = s_cases[name].Json
            .Replace("MESH", Mesh, StringComparison.Ordinal).Replace("TURNED", Turned, StringComparison.Ordinal).Replace("MOVING", Moving, StringComparison.Ordinal)
            .Replace("SHINES", """ "material": { "type": "luminaire", "multiplier": 2 } """, StringComparison.Ordinal)
            .Replace("SPOTS", """ "material": { "type": "luminaire", "multiplier": 2, "exponent": 3.5 } """, StringComparison.Ordinal);
        bool isEnvironment = name.Contains("sky", StringComparison.Ordinal) || name.Contains("environment", StringComparison.Ordinal);
        Scene scene = TestScenes.Build($$"""
            { "render": { "integrator": "light", "shutter": [0, 1] }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 2 }],
              "{{(isEnvironment ? "environment" : "lights")}}": {{(isEnvironment ? json : $"[{json}]")}} }
            """);
        LightSource light = Assert.Single(scene.SampledLights);
        Assert.True(light.CanEmit);
        return (scene, light);
    }

    private sealed class PlugIn(Material material) : Shape(material, "")
    {
        public override Bounds Bounds => default;

        public override float Area => 1;

        public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => throw new NotSupportedException();

        public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample) => sample = default;
    }

    private delegate void RayVisitor(in EmittedW ray, in FloatW time, int lane);

    private static void Trace(Scene scene, int count, RayVisitor visit)
    {
        LightEmission emission = new(scene);
        IndependentSampler sampler = new(count);
        uint key = Hash.PixelKey((uint)TestSettings.Seed, 3);
        for (int i = 0; i < count; i += FloatW.Count)
        {
            UIntW sample = UIntW.Iota + (uint)i;
            sampler.Begin(key, sample, Dimensions.Time, out SamplePoints points);
            sampler.Pair(points, 0, out FloatW time, out _);
            emission.Start(sampler, key, sample, time, MaskW.All, out _, out EmittedW ray);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                visit(ray, time, lane);
            }
        }
    }

    // What points of the sphere receive by the lights' own samples: for each, its share of all rays is the density of the ray that arrives times cosine and
    // solid angle here, over the cosine there.
    private static Cells Expect(LightSource light)
    {
        const int samples = 16;
        bool isFar = IsFar(light);
        Random random = new(1);
        Cells cells = new();
        for (int i = 0; i < Rings * Side * Sectors * Side; i++)
        {
            double z = (((i % (Rings * Side)) + random.NextDouble()) * 2 / (Rings * Side)) - 1;
            double turn = ((i / (Rings * Side)) + random.NextDouble()) * 2 * Math.PI / (Sectors * Side);
            (double count, double power) = (0, 0);
            uint pairing = (uint)random.Next(samples);
            Vector3D normal = new(Math.Sqrt(1 - (z * z)) * Math.Cos(turn), Math.Sqrt(1 - (z * z)) * Math.Sin(turn), z);
            double radius = isFar ? FarRadius : NearRadius;
            double share = 4 * Math.PI * radius * radius / (Rings * Side * Sectors * Side) / samples;
            Vector3 from = (Vector3)(normal * radius);
            (float shiftU, float shiftV, float shiftTime) = (random.NextSingle(), random.NextSingle(), random.NextSingle());
            for (int first = 0; first < samples; first += FloatW.Count)
            {
                UIntW index = UIntW.Iota + (uint)first;
                FloatW u = ((index & 3u).ToFloat() + shiftU) * 0.25f;
                FloatW v = ((index >> 2).ToFloat() + shiftV) * 0.25f;
                FloatW time = (((index * 7u + pairing) & 15u).ToFloat() + shiftTime) * (1f / samples);
                light.Sample(from, u, v, time, out ShapeSampleW sample, out RgbW radiance);
                light.EmissionPdf(from, sample, time, out FloatW point, out FloatW direction);
                for (int lane = 0; lane < FloatW.Count; lane++)
                {
                    double cosine = Vector3D.Of(sample.Direction, lane).Dot(normal) * (isFar ? 1 : -1);
                    if (sample.InversePdf[lane] > 0 && cosine > 0)
                    {
                        double angle = light.IsDelta && !isFar ? 1 / ((double)sample.Distance[lane] * sample.Distance[lane]) : sample.InversePdf[lane];
                        count += share * cosine * angle * point[lane] * direction[lane] / sample.Cosine[lane];
                        power += share * cosine * radiance.G[lane];
                    }
                }
            }

            cells.Add(CellOf(normal), count, power);
        }

        return cells;
    }

    // Where a ray leaves the sphere around a near light, or enters that inside of a far one's scene.
    private static Vector3D? Meet(in EmittedW ray, int lane, bool isFar)
    {
        (Vector3D origin, Vector3D direction) = (Vector3D.Of(ray.Origin, lane), Vector3D.Of(ray.Direction, lane));
        double radius = isFar ? FarRadius : NearRadius;
        double along = -origin.Dot(direction);
        double root = (along * along) - origin.Squared + (radius * radius);
        return root < 0 ? null : (origin + (direction * (along + (isFar ? -Math.Sqrt(root) : Math.Sqrt(root))))) * (1 / radius);
    }

    private static int CellOf(Vector3D normal)
    {
        double turn = Math.Atan2(normal.Y, normal.X) / (2 * Math.PI);
        int ring = Math.Clamp((int)((normal.Z + 1) / 2 * Rings), 0, Rings - 1);
        return (ring * Sectors) + Math.Min((int)((turn < 0 ? turn + 1 : turn) * Sectors), Sectors - 1);
    }

    private static bool IsFar(LightSource light) => !light.Extent((0, 1)).Box.IsFinite;

    private static bool Bit(MaskW mask, int lane) => (mask.Bits >> lane & 1) != 0;

    private static string Columns(double[] a, double[] b) => string.Join('\n', a.Zip(b, (x, y) => string.Create(CultureInfo.InvariantCulture, $"{x:G5} {y:G5}")));

    // Of each cell of the sphere: sums of rays and of power, and of their squares.
    private sealed class Cells
    {
        public double[] Counts { get; } = new double[Rings * Sectors];

        public double[] CountSquares { get; } = new double[Rings * Sectors];

        public double[] Power { get; } = new double[Rings * Sectors];

        public double[] PowerSquares { get; } = new double[Rings * Sectors];

        // The p-value of sums over the rays beside sums over the points of each cell; cells that few rays meet are one.
        public static double Compare(double[] found, double[] foundSquares, double[] expected, double[] expectedSquares)
        {
            double sum = 0;
            int cells = 0;
            (double apart, double variance, double size) = (0, 0, 0);
            foreach (int i in Enumerable.Range(0, found.Length).OrderBy(i => expected[i]))
            {
                apart += found[i] - (expected[i] * Rays);
                variance += foundSquares[i] - (found[i] * found[i] / Rays) + (((double)Rays * Rays) * (expectedSquares[i] - (expected[i] * expected[i] / (Side * Side))));
                size += foundSquares[i] > 0 ? found[i] * found[i] / foundSquares[i] : 0;
                if (size >= 50)
                {
                    sum += apart * apart / variance;
                    cells++;
                    (apart, variance, size) = (0, 0, 0);
                }
            }

            return PValues.ChiSquared(sum, cells);
        }

        public void Add(int cell, double count, double power)
        {
            Counts[cell] += count;
            CountSquares[cell] += count * count;
            Power[cell] += power;
            PowerSquares[cell] += power * power;
        }
    }
}
