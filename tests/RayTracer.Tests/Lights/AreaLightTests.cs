using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Lights;

/// <summary>What holds for the sampling of every light: the cases of <see cref="LightCase"/>.</summary>
[Trait("Category", "Thorough")]
public class AreaLightTests
{
    public static TheoryData<string> Cases() => [.. LightCase.All.Select(c => c.Name)];

    [Theory]
    [MemberData(nameof(Cases))]
    public void Points_are_uniform_by_area_or_directions_in_the_cone(string name)
    {
        LightCase light = LightCase.Of(name);
        bool isCone = light.Shape is Sphere { LightSampling: SphereLightSampling.Cone };
        UnitSquareCounts counts = new();

        // Where on a curved solid a point lies takes long to find.
        int everyday = light.Shape is ConicalShape or Torus ? 1 << 16 : 1 << 18;
        UnitSquare.AtRandom(TestSettings.Scale(everyday, 1 << 20), (u, v, lane) =>
        {
            light.Shape.SamplePoint(light.From, u, v, out ShapeSampleW sample);
            if (!isCone || sample.InversePdf[lane] > 0)
            {
                Vector3D d = Vector3D.Of(sample.Direction, lane);
                (double s, double t) = isCone ? light.ConeSquareOf(d) : light.SquareOf((d * sample.Distance[lane]) + light.From);
                counts.Add(s, t);
            }
        });
        ErrorBudget.Lights.Check(isCone && light.ConeHeight == 0 ? 1 : counts.P(), $"points of {name}");
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Each_sample_is_a_point_of_the_light_with_its_pdf_per_solid_angle(string name)
    {
        LightCase light = LightCase.Of(name);
        bool isCone = light.Shape is Sphere { LightSampling: SphereLightSampling.Cone };
        UnitSquare.OnGrid(6, (u, v, lane) =>
        {
            light.Shape.SamplePoint(light.From, u, v, out ShapeSampleW sample);
            Vector3D d = Vector3D.Of(sample.Direction, lane);
            Vector3D p = (d * sample.Distance[lane]) + light.From;
            double distance = ((Vector3D)light.From - p).Length;
            double cosine = -light.NormalAt(p).Dot(d);
            if (isCone)
            {
                Assert.InRange(sample.InversePdf[lane], light.SolidAngle * (1 - 1e-4), light.SolidAngle * (1 + 1e-4));
                Assert.True(light.SolidAngle == 0 || Math.Abs((p - ((Sphere)light.Shape).Center).Length - 1.2) < 2e-6 * distance + 2e-4);
            }
            else
            {
                double inversePdf = cosine <= 0 ? 0 : light.SampledArea * cosine / (distance * distance);

                // From afar, a float direction and distance tell the point, and so the normal, less exactly.
                double tolerance = (2e-5 + (1e-6 * distance)) * light.Shape.Area / (distance * distance);
                Assert.Equal(inversePdf, sample.InversePdf[lane], tolerance);
            }

            if (sample.InversePdf[lane] > 0)
            {
                Assert.Equal(1, d.Length, 5);
                Assert.Equal(cosine, sample.Cosine[lane], 2e-3);
            }
        });
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Samples_integrate_to_the_solid_angle_and_the_irradiance(string name)
    {
        LightCase light = LightCase.Of(name);
        double solidAngle = 0;
        Vector3D irradiance = default;
        UnitSquare.OnGrid(9, (u, v, lane) =>
        {
            light.Shape.SamplePoint(light.From, u, v, out ShapeSampleW sample);
            solidAngle += sample.InversePdf[lane] / (512 * 512);
            irradiance += Vector3D.Of(sample.Direction, lane) * (sample.InversePdf[lane] / (512.0 * 512));
        });
        double tolerance = 1e-4 * light.SolidAngle;
        Assert.True(Math.Abs(solidAngle - light.SolidAngle) <= tolerance, $"{name}: solid angle {solidAngle} instead of {light.SolidAngle}");
        Assert.True((irradiance - light.VectorIrradiance).Length <= tolerance, $"{name}: {irradiance} instead of {light.VectorIrradiance}");
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Radiance_is_that_of_the_sampled_point_towards_the_lit_one(string name)
    {
        LightCase light = LightCase.Of(name);
        AreaLight area = new(light.Shape, 0);
        UnitSquare.OnGrid(6, (u, v, lane) =>
        {
            area.Sample(light.From, u, v, out ShapeSampleW sample, out RgbW radiance);
            (double U, double V) uv = light.UvOf((Vector3D.Of(sample.Direction, lane) * sample.Distance[lane]) + light.From);
            double emitted = LightCase.Multiplier * Math.Pow(Math.Max(sample.Cosine[lane], 0), LightCase.Exponent) * sample.InversePdf[lane];
            double tolerance = 1e-3 * LightCase.Multiplier * sample.InversePdf[lane];
            Assert.Equal(emitted * uv.U, radiance.R[lane], tolerance);
            Assert.Equal(emitted * uv.V, radiance.G[lane], tolerance);
            Assert.Equal(emitted, radiance.B[lane], tolerance);
        });
    }

    [Fact]
    public void No_face_of_a_box_is_seen_from_inside()
    {
        LightCase light = LightCase.Of("box");
        AreaLight area = new(light.Shape, 0);
        UnitSquare.OnGrid(3, (u, v, lane) =>
        {
            area.Sample(new Vec3W(0.1f, 0.1f, 0f), u, v, out ShapeSampleW sample, out RgbW radiance);
            Assert.Equal((0, 0, 0, 0), (sample.InversePdf[lane], radiance.R[lane], radiance.G[lane], radiance.B[lane]));
        });
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(3.5)]
    public void A_sphere_of_one_colour_shines_like_any_other(float exponent)
    {
        // Spheres of one colour take a way of their own, without uv.
        LightCase light = LightCase.Of("sphere by cone");
        var shape = (Sphere)light.Shape;
        Rgb color = new(0.2f, 0.6f, 1.5f);
        var lamp = new LuminaireMaterial(new SolidTexture(color), 4, exponent, null);
        AreaLight area = new(new Sphere(lamp, "", shape.Center, shape.Radius) { LightSampling = SphereLightSampling.Cone }, 0);
        UnitSquare.OnGrid(5, (u, v, lane) =>
        {
            area.Sample(light.From, u, v, out ShapeSampleW sample, out RgbW radiance);
            shape.SamplePoint(light.From, u, v, out ShapeSampleW expected);
            Assert.Equal(Vector3D.Of(expected.Direction, lane), Vector3D.Of(sample.Direction, lane));
            Assert.Equal(expected.Distance[lane], sample.Distance[lane]);
            double emitted = 4 * Math.Pow(sample.Cosine[lane], exponent) * light.SolidAngle;
            Assert.Equal(emitted * color.R, radiance.R[lane], 1e-4 * light.SolidAngle);
            Assert.Equal(emitted * color.G, radiance.G[lane], 1e-4 * light.SolidAngle);
            Assert.Equal(emitted * color.B, radiance.B[lane], 1e-4 * light.SolidAngle);
        });
    }
}
