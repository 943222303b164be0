using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Materials;

public class MaterialTests
{
    private const int SideBits = 8;
    private const int Side = 1 << SideBits;
    private const int Count = Side * Side;

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.6)]
    [InlineData(0.1)]
    public void Diffuse_scattering_is_the_colour_and_stays_on_the_rays_side(double cosine)
    {
        Material material = new DiffuseMaterial(new SolidTexture(new(0.2f, 0.5f, 0.8f)));
        foreach (bool inside in new[] { false, true })
        {
            (SurfaceW surface, Vector3 facing) = Surface(cosine, inside);
            ForEachScatter(material, surface, 4096, s =>
            {
                Assert.Equal(new Rgb(0.2f, 0.5f, 0.8f), Weight(s));
                Assert.True(Vector3.Dot(Direction(s), facing) >= 0);
                Assert.False(s.Specular.Any);
            });
        }
    }

    [Fact]
    public void Phong_metal_reflects_around_the_mirror_direction_and_ends_below_the_surface()
    {
        Material material = new PhongMetalMaterial(new SolidTexture(Rgb.White), 20);
        (SurfaceW surface, Vector3 facing) = Surface(0.3, inside: false);
        Vector3 mirror = Vector3.Reflect(ToVector(surface.Incoming), facing);
        double mean = 0;
        int absorbed = 0;
        ForEachScatter(material, surface, Count, s =>
        {
            mean += (double)Vector3.Dot(Direction(s), mirror) / Count;
            bool below = Vector3.Dot(Direction(s), facing) <= 0;
            Assert.Equal(below, s.Absorbed.Bits != 0);
            absorbed += below ? 1 : 0;
            Assert.True(s.Specular.Any);
        });
        Assert.Equal(21.0 / 22, mean, 1e-4);
        Assert.InRange(absorbed, 1, Count / 2);
    }

    [Theory]
    [InlineData(1.5, 0.9)]
    [InlineData(1.333, 0.4)]
    [InlineData(2.417, 0.05)]
    public void Dielectric_obeys_Snell_and_Fresnel_from_outside(double index, double cosine) => AssertDielectric(index, cosine, inside: false);

    [Theory]
    [InlineData(1.5, 0.9)]
    [InlineData(1.333, 0.8)]
    [InlineData(2.417, 0.2)]
    public void Dielectric_obeys_Snell_and_Fresnel_from_inside(double index, double cosine) => AssertDielectric(index, cosine, inside: true);

    [Theory]
    [InlineData(FresnelModel.Exact, 1.5, 0.7)]
    [InlineData(FresnelModel.Exact, 2.417, 0.1)]
    [InlineData(FresnelModel.Schlick, 1.5, 0.7)]
    [InlineData(FresnelModel.Schlick, 1.5, 0.2)]
    [InlineData(FresnelModel.Exact, 0.75, 0.8)]
    public void Refraction_is_reciprocal_in_radiance_over_the_squared_index(FresnelModel model, double index, double cosine)
    {
        Material material = new DielectricMaterial((float)index, Rgb.Black, model);
        (SurfaceW there, _) = Surface(cosine, inside: false);
        Vector3 inward = RefractedOf(material, there, out double weightThere, out double shareThere);
        SurfaceW back = there;
        SurfaceCase.Turn(ref back, -(Vector3D)inward);
        Vector3 outward = RefractedOf(material, back, out double weightBack, out double shareBack);
        AssertNear(-ToVector(there.Incoming), outward);
        Assert.Equal(shareThere, shareBack, 2.0 / Side);
        Assert.Equal(weightThere * index * index, weightBack / (index * index), 1e-4);
    }

    [Theory]
    [InlineData(1.5, 0.9)]
    [InlineData(1.5, 0.1)]
    [InlineData(2.417, 0.5)]
    public void Schlicks_glass_reflects_by_the_angle_on_the_thinner_side(double index, double cosine)
    {
        double r0 = Math.Pow((index - 1) / (index + 1), 2);
        Material material = new DielectricMaterial((float)index, Rgb.Black, FresnelModel.Schlick);
        RefractedOf(material, Surface(cosine, inside: false).Surface, out _, out double share);
        Assert.Equal(1 - r0 - ((1 - r0) * Math.Pow(1 - cosine, 5)), share, 1.0 / Side);
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.4)]
    [InlineData(0.1)]
    public void A_cosine_lobe_loses_what_the_surface_cuts_off(double cosine)
    {
        // The cosine around the mirror direction, cut by the surface, is a form factor known in closed form: (1 + cos)/2.
        Material material = new PhongMetalMaterial(new SolidTexture(Rgb.White), 1);
        double energy = 0;
        ForEachScatter(material, Surface(cosine, inside: false).Surface, Count, s => energy += s.Absorbed.Bits != 0 ? 0 : Weight(s).G / Count);
        Assert.Equal((1 + cosine) / 2, energy, 1e-3);
    }

    [Fact]
    public void Light_that_comes_from_inside_was_absorbed_by_Beers_law()
    {
        Material material = new DielectricMaterial(1.5f, new(0.1f, 0.5f, 2), FresnelModel.Exact);
        (SurfaceW surface, _) = Surface(0.2, inside: true);
        surface.Distance = 0.7f;
        ForEachScatter(material, surface, 16, s =>
        {
            Assert.Equal(Math.Exp(-0.07), Weight(s).R, 5);
            Assert.Equal(Math.Exp(-0.35), Weight(s).G, 5);
            Assert.Equal(Math.Exp(-1.4), Weight(s).B, 5);
        });
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.5)]
    [InlineData(0.02)]
    public void Coat_is_seen_by_Schlicks_share_and_chosen_by_its_root_and_the_rest_is_lit(double cosine)
    {
        const double r0 = 0.05;
        double reflectance = r0 + ((1 - r0) * Math.Pow(1 - cosine, 5));
        Material material = new DiffuseSpecularMaterial(
            new DiffuseMaterial(new SolidTexture(new(0.5f, 0.5f, 0.5f))), new PhongMetalMaterial(new SolidTexture(Rgb.White), 1e6f), (float)r0);
        (SurfaceW surface, _) = Surface(cosine, inside: false);
        material.Prepare(ref surface);
        (int coat, double seen, double rest) = (0, 0, 0);
        ForEachScatter(material, surface, Count, s =>
        {
            coat += s.Specular.Any ? 1 : 0;
            seen += s.Specular.Any ? s.Weight.G[0] : 0;
            rest += s.Specular.Any ? 0 : s.Weight.G[0];
        });
        Assert.Equal(Math.Sqrt(reflectance), (double)coat / Count, 1e-4);
        Assert.Equal(reflectance, seen / Count, 1e-4);
        Assert.Equal(0.5 * (1 - reflectance), rest / Count, 1e-4);
        material.Brdf(surface, out RgbW brdf);
        Assert.Equal(0.5 / Math.PI * (1 - reflectance), brdf.G[0], 5);
        material.AmbientResponse(surface, out RgbW ambient);
        Assert.Equal((0.5 * (1 - reflectance)) + reflectance, ambient.G[0], 5);
    }

    [Theory]
    [InlineData(0, 0.3, 5)]
    [InlineData(1, 0.3, 1.5)]
    [InlineData(4, 0.5, 0.3125)]
    [InlineData(2, -0.5, 0)]
    public void Luminaire_shines_by_a_power_of_the_cosine_on_the_outside(float exponent, float cosine, double expected)
    {
        Material material = new LuminaireMaterial(new SolidTexture(new(1, 0.5f, 0)), 5, exponent, null);
        material.Emission(cosine, 0f, 0f, out RgbW radiance);
        Assert.Equal(expected, radiance.R[0], 5);
        Assert.Equal(expected / 2, radiance.G[0], 5);
        Assert.Equal(0, radiance.B[0]);
    }

    [Fact]
    public void Fresnel_is_what_the_textbook_says_at_normal_incidence_and_at_Brewsters_angle()
    {
        Assert.Equal(0.04, Fresnel.Dielectric(1f, 1f, 1 / 1.5f)[0], 6);
        double brewster = Math.Atan(1.5);
        double refracted = Math.Asin(Math.Sin(brewster) / 1.5);
        double perpendicular = Math.Pow(Math.Sin(brewster - refracted) / Math.Sin(brewster + refracted), 2);
        Assert.Equal(perpendicular / 2, Fresnel.Dielectric((float)Math.Cos(brewster), (float)Math.Cos(refracted), 1 / 1.5f)[0], 6);
    }

    private static void AssertDielectric(double index, double cosine, bool inside)
    {
        Material material = new DielectricMaterial((float)index, Rgb.Black, FresnelModel.Exact);
        (SurfaceW surface, Vector3 facing) = Surface(cosine, inside);
        double eta = inside ? index : 1 / index;
        double sin = Math.Sqrt(1 - (cosine * cosine));
        double sinT = eta * sin;
        double cosT = Math.Sqrt(Math.Max(0, 1 - (sinT * sinT)));
        double parallel = (cosine - (eta * cosT)) / (cosine + (eta * cosT));
        double perpendicular = ((eta * cosine) - cosT) / ((eta * cosine) + cosT);
        double reflectance = sinT >= 1 ? 1 : ((parallel * parallel) + (perpendicular * perpendicular)) / 2;
        int reflected = 0;
        ForEachScatter(material, surface, Count, s =>
        {
            double along = Vector3.Dot(Direction(s), facing);
            if (along > 0)
            {
                reflected++;
                Assert.Equal(cosine, along, 4);
                AssertNear(Vector3.Reflect(ToVector(surface.Incoming), facing), Direction(s));
                Assert.Equal(1, Weight(s).R);
            }
            else
            {
                Assert.Equal(cosT, -along, 4);

                // Snell's law as vectors: what lies along the surface is scaled by η.
                Vector3 tangential = ToVector(surface.Incoming) + (facing * (float)cosine);
                AssertNear((tangential * (float)eta) - (facing * (float)cosT), Direction(s));
                Assert.Equal(eta * eta, Weight(s).R, 4);
            }
        });

        // Each of the grid's columns reflects or refracts as a whole.
        Assert.Equal(reflectance, (double)reflected / Count, 1.0 / Side);
    }

    private static Vector3 RefractedOf(Material material, in SurfaceW surface, out double weight, out double share)
    {
        (Vector3 direction, double sum, int count) = (default, 0, 0);
        Vector3 facing = ToVector(surface.Facing);
        ForEachScatter(material, surface, Count, s =>
        {
            if (Vector3.Dot(Direction(s), facing) < 0)
            {
                direction = Direction(s);
                sum += Weight(s).R;
                count++;
            }
        });
        weight = sum / count;
        share = (double)count / Count;
        return direction;
    }

    private static (SurfaceW Surface, Vector3 Facing) Surface(double cosine, bool inside)
    {
        Vector3 normal = Vector3.Normalize(new(0.3f, 0.8f, -0.4f));
        Vector3 side = Vector3.Normalize(Vector3.Cross(normal, Vector3.UnitX));
        Vector3 facing = inside ? -normal : normal;
        Vector3 incoming = (-facing * (float)cosine) + (side * (float)Math.Sqrt(1 - (cosine * cosine)));
        SurfaceW surface = default;
        surface.Normal = normal;
        surface.Facing = facing;
        surface.Incoming = incoming;
        surface.Cosine = (float)cosine;
        surface.Inside = inside ? MaskW.All : MaskW.None;
        return (surface, facing);
    }

    private static void ForEachScatter(Material material, SurfaceW surface, int count, Action<ScatterW> action)
    {
        // The first samples of the grid are its first row: those of the first number, evenly spaced.
        VertexSamples samples = new(new GridSampler(SideBits));
        material.Prepare(ref surface);
        for (int i = 0; i < count; i++)
        {
            samples.Begin(0u, (uint)i, 0u);
            material.Scatter(surface, samples, out ScatterW scatter);
            action(scatter);
        }
    }

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True((expected - actual).Length() < 1e-5f, $"{actual} is not {expected}");

    private static Vector3 Direction(ScatterW s) => ToVector(s.Direction);

    private static Rgb Weight(ScatterW s) => new(s.Weight.R[0], s.Weight.G[0], s.Weight.B[0]);

    private static Vector3 ToVector(Vec3W v) => new(v.X[0], v.Y[0], v.Z[0]);
}
