using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Materials;

/// <summary>
/// Normal and bump maps against closed forms. The figures beside them are those of another renderer (Mitsuba 3.9.1, <c>normalmap</c> with and without
/// <c>flip_invalid_normals</c> and <c>use_shadowing_function</c>, within and around <c>twosided</c>), for the normal (0.5, 0.2, 1) and a white matt surface: π/4 times the BSDF and the cosine.
/// </summary>
public class PerturbedMaterialTests
{
    private static readonly Vector3D s_normal = new Vector3D(0.5, 0.2, 1).Unit;

    public enum Sides
    {
        One,
        Within,
        Around,
    }

    [Theory]
    [InlineData(Sides.One, TurnedNormal.Back, false, 0, 0, 1, 1, 0, 1, 0.2335)]
    [InlineData(Sides.One, TurnedNormal.Back, true, 0, 0, 1, 1, 0, 1, 0.2314)]
    [InlineData(Sides.One, TurnedNormal.Back, true, 0, 0, 1, -0.5, -3, 1, 0.0096)]
    [InlineData(Sides.One, TurnedNormal.Flip, false, 0, 0, 1, 0.5, 0.5, -0.2, 0)]
    [InlineData(Sides.One, TurnedNormal.Back, false, -3, 0, 1, 1, 0, 1, 0)]
    [InlineData(Sides.One, TurnedNormal.Flip, false, -3, 0, 1, 1, 0, 1, 0.0778)]
    [InlineData(Sides.One, TurnedNormal.Flip, true, -3, 0, 1, -2, 0, 1.1, 0.1968)]
    [InlineData(Sides.Within, TurnedNormal.Back, false, 0.1, 0, 1, 0.3, 0.3, 1, 0.2452)]
    [InlineData(Sides.Within, TurnedNormal.Back, false, 0.1, 0, -1, -0.3, 0.3, -1, 0.1844)]
    [InlineData(Sides.Within, TurnedNormal.Back, true, 0.1, 0, -1, 1, 0, -0.1, 0.0834)]
    [InlineData(Sides.Within, TurnedNormal.Back, false, -3, 0, -1, -0.3, 0.3, -1, 0)]
    [InlineData(Sides.Within, TurnedNormal.Flip, false, -3, 0, -1, -0.3, 0.3, -1, 0.2209)]
    [InlineData(Sides.Around, TurnedNormal.Back, false, 0.1, 0, -1, -0.3, 0.3, -1, 0.2209)]
    [InlineData(Sides.Around, TurnedNormal.Back, true, 0.1, 0, -1, -0.3, 0.3, -1, 0.2205)]
    [InlineData(Sides.Around, TurnedNormal.Back, false, -3, 0, 1, -0.3, 0.3, -1, 0.2209)]
    [InlineData(Sides.Around, TurnedNormal.Flip, false, -3, 0, 1, -1, 0, 0.1, 0.1314)]
    [InlineData(Sides.Around, TurnedNormal.Flip, false, 3, 0, -1, -0.3, 0.3, -1, 0.1844)]
    [InlineData(Sides.Around, TurnedNormal.Back, true, 3, 0, -1, 0.3, 0.3, 1, 0.2448)]
    public void Normal_maps_scatter_as_in_another_renderer(
        Sides sides, TurnedNormal turned, bool softens, double viewX, double viewY, double viewZ, double lightX, double lightY, double lightZ, double expected)
    {
        Material matt = new DiffuseMaterial(new SolidTexture(Rgb.White));
        Material one = new OneSidedMaterial(matt);
        Vector3D color = (s_normal * 0.5) + new Vector3D(0.5, 0.5, 0.5);
        NormalMapMaterial map = new(sides == Sides.Around ? new TwoSidedMaterial(one, one) : one, new SolidTexture(new((float)color.X, (float)color.Y, (float)color.Z)), 1)
        {
            Turned = turned,
            SoftensShadow = softens,
        };
        Material material = sides == Sides.Within ? new TwoSidedMaterial(map, map) : map;
        SurfaceW surface = Surface(new Vector3D(viewX, viewY, viewZ).Unit);
        material.Prepare(ref surface);
        Vector3D light = new Vector3D(lightX, lightY, lightZ).Unit;
        material.Bsdf(surface, (Vector3)light, out RgbW bsdf);
        double cosine = Math.Abs(Vector3D.Of(surface.Facing, 0).Dot(light));
        Assert.Equal(expected, bsdf.G[0] * cosine * Math.PI / 4, 6e-5);
    }

    [Theory]
    [InlineData(TurnedNormal.Mirror)]
    [InlineData(TurnedNormal.Flip)]
    [InlineData(TurnedNormal.Back)]
    public void The_cosine_is_that_of_the_normal_which_is_seen(TurnedNormal turned)
    {
        // Steep maps, seen at all angles from both sides: many are turned away, and some of them cannot be flipped into view either.
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 500; i++)
        {
            NormalMapMaterial map = new(new DiffuseMaterial(new SolidTexture(Rgb.White)), new SolidTexture(new((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble())), 1) { Turned = turned };
            SurfaceW surface = Surface(new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, (random.NextDouble() - 0.5) / 2).Unit);
            map.Prepare(ref surface);
            Assert.Equal(-Vector3D.Of(surface.Incoming, 0).Dot(Vector3D.Of(surface.Facing, 0)), surface.Cosine[0], 2e-6);
            Assert.Equal(1, Vector3D.Of(surface.Facing, 0).Length, 1e-5);
        }
    }

    [Fact]
    public void Hills_of_a_picture_have_its_exact_slopes()
    {
        // Heights 0, 1 / 0, 0 from the top: at u, v in the middle square, 4·(v − ¼) along u and 4·(u − ¼) along v.
        ImageTexture picture = new(new(2, 2, [0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0]), Interpolation.Bilinear, Wrapping.Clamp, Vector2.One, Vector2.Zero);
        PlacedTexture placed = new(picture, new(0.5f, 0.5f), 90, new(0.8f, 0.3f));
        foreach ((float u, float v) in ((float, float)[])[(0.3f, 0.4f), (0.7f, 0.26f), (0.5f, 0.6f)])
        {
            TexturePointW at = new() { U = u, V = v };
            picture.Slope(at, out FloatW alongU, out FloatW alongV);
            Assert.Equal(4 * (v - 0.25), alongU[0], 1e-5);
            Assert.Equal(4 * (u - 0.25), alongV[0], 1e-5);

            // u′ = 0.8 − v/2, v′ = 0.3 + u/2.
            placed.Slope(at, out alongU, out alongV);
            Assert.Equal(4 * (0.8 - (v / 2) - 0.25) / 2, alongU[0], 1e-5);
            Assert.Equal(-4 * (0.3 + (u / 2) - 0.25) / 2, alongV[0], 1e-5);
        }
    }

    [Theory]
    [InlineData(false, 1, 1)]
    [InlineData(false, -1, 1)]
    [InlineData(true, 1, 1)]
    [InlineData(true, -1, -1)]
    public void Green_points_to_the_left_of_u_or_along_v(bool alongV, int mirrored, int expected)
    {
        NormalMapMaterial map = new(new DiffuseMaterial(new SolidTexture(Rgb.White)), new SolidTexture(new(0.5f, 0.9f, 0.8f)), 1) { GreenAlongV = alongV };
        SurfaceW surface = Surface(new(0, 0, 1));
        surface.AlongV = new(0f, mirrored, 0f);
        map.Prepare(ref surface);
        Assert.Equal(expected * 0.8f, surface.Facing.Y[0], 1e-5f);
        Assert.Equal(0.6f, surface.Facing.Z[0], 1e-5f);
    }

    // The plane z = 0, u along x.
    private static SurfaceW Surface(Vector3D view)
    {
        SurfaceW surface = default;
        surface.Normal = new(0f, 0f, 1f);
        SurfaceCase.Turn(ref surface, -view);
        surface.AlongU = new(1f, 0f, 0f);
        surface.AlongV = new(0f, 1f, 0f);
        surface.Tint = Rgb.White;
        surface.SetTangent();
        return surface;
    }
}
