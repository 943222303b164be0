using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Tests.Materials;

/// <summary>Thin sheets against the numbers that Mitsuba 3.9.1 computes for its <c>principledthin</c>; there, the matt part that passes through goes from 0 to 2.</summary>
public class ThinPrincipledMaterialTests
{
    private static readonly Dictionary<string, PrincipledTextures> s_sheets = new()
    {
        ["paper"] = new()
        {
            BaseColor = new SolidTexture(new(0.7f, 0.4f, 0.2f)),
            Roughness = Solid(0.8f),
            DiffuseTransmission = Solid(0.6f),
            Sheen = Solid(0.8f),
            SheenTint = Solid(0.4f),
            Flatness = Solid(0.5f),
            RefractiveIndex = Solid(1.5f),
        },
        ["pane"] = new() { BaseColor = new SolidTexture(new(0.7f, 0.4f, 0.9f)), Roughness = Solid(0.4f), Transmission = Solid(1), SpecularTint = Solid(0.4f), RefractiveIndex = Solid(1.4f) },
        ["curtain"] = new()
        {
            BaseColor = new SolidTexture(new(0.9f, 0.7f, 0.5f)),
            Roughness = Solid(0.6f),
            Transmission = Solid(0.7f),
            Anisotropic = Solid(0.7f),
            DiffuseTransmission = Solid(0.4f),
            RefractiveIndex = Solid(1.7f),
        },
    };

    [Theory]
    [InlineData("paper", false, 0, 0.0745407, 0.0425948, 0.0212976)]
    [InlineData("paper", false, 1, 0.0895379, 0.0512019, 0.0256445)]
    [InlineData("paper", false, 2, 0.13369, 0.0763944, 0.0381972)]
    [InlineData("paper", true, 0, 0.088361, 0.0505943, 0.0254166)]
    [InlineData("paper", true, 1, 0.140314, 0.0865652, 0.0507326)]
    [InlineData("pane", false, 0, 0.0951813, 0.0755957, 0.108238)]
    [InlineData("pane", false, 1, 0.00170052, 0.00137433, 0.00191799)]
    [InlineData("pane", false, 2, 4.00974, 2.29128, 5.15538)]
    [InlineData("pane", false, 3, 0, 0, 0)]
    [InlineData("pane", true, 0, 0.00376621, 0.00308164, 0.00422259)]
    [InlineData("pane", true, 1, 0.0526973, 0.0498314, 0.0546078)]
    [InlineData("pane", true, 2, 0.00395722, 0.00226127, 0.00508785)]
    [InlineData("curtain", false, 0, 0.0815927, 0.0701336, 0.0586744)]
    [InlineData("curtain", false, 1, 0.0547041, 0.0429457, 0.0311872)]
    [InlineData("curtain", false, 2, 1.12218, 0.872805, 0.623432)]
    [InlineData("curtain", false, 3, 0.0343775, 0.026738, 0.0190986)]
    [InlineData("curtain", true, 1, 0.0746472, 0.0638856, 0.053124)]
    [InlineData("curtain", true, 2, 0.0570692, 0.0443872, 0.0317051)]
    public void A_sheet_scatters_what_Mitsubas_scatters(string sheet, bool isGrazing, int direction, double r, double g, double b)
    {
        Vec3W view = isGrazing ? new(0.866449f, 0.324918f, 0.379071f) : new(0.309426f, -0.206284f, 0.928279f);
        Vec3W[] lights = [new(-0.348743f, 0.116248f, 0.929981f), new(-0.717137f, -0.597614f, 0.358569f), new(-0.20937f, 0.261712f, -0.942163f), new(0.569803f, -0.683763f, -0.455842f)];
        ThinPrincipledMaterial material = new(s_sheets[sheet]);

        // From the front, and, as both sides are alike, mirrored, from behind.
        foreach (float side in new[] { 1f, -1f })
        {
            SurfaceW surface = default;
            surface.Incoming = -new Vec3W(view.X, view.Y, view.Z * side);
            surface.Normal = new(0f, 0f, 1f);
            surface.Facing = new(0f, 0f, side);
            surface.Tangent = new(1f, 0f, 0f);
            surface.Inside = side < 0 ? MaskW.All : MaskW.None;
            material.Prepare(ref surface);
            Vec3W light = lights[direction];
            material.Bsdf(surface, new(light.X, light.Y, light.Z * side), out RgbW bsdf);
            Assert.Equal(r, bsdf.R[0], 1e-6 + (1e-4 * r));
            Assert.Equal(g, bsdf.G[0], 1e-6 + (1e-4 * g));
            Assert.Equal(b, bsdf.B[0], 1e-6 + (1e-4 * b));
        }
    }

    private static SolidTexture Solid(float value) => new(new(value, value, value));
}
