using RayTracer.Rendering;

namespace RayTracer.Scenes.Tests;

/// <summary>Covers <see cref="IntegratorAdvice"/>: one scene for each of its rules.</summary>
public sealed class IntegratorAdviceTests
{
    private const string Lamp = """{ "type": "sphere", "center": [0, 3, 0], "radius": RADIUS, "material": { "type": "luminaire" } }""";

    [Theory]
    [InlineData("cornell", "path", "no glass or mirror")]
    [InlineData("gallery/grove", "path", "no glass or mirror")]
    [InlineData("media/01-milk-and-fog", "volPath", "no glass or mirror")]
    [InlineData("media/02-tea", "path", "no glass or mirror")]
    [InlineData("caustics/04-pool", "vcm", "glass or mirrors gather")]
    [InlineData("gallery/prism", "bidirectional", "one at a time")]
    [InlineData("report/scene2", "report", "the scene asks for it")]
    public void Shipped_scenes_are_advised_by_what_they_have(string scene, string integrator, string reason) =>
        AssertAdvice(integrator, reason, SceneLoader.Load(ProjectFolder.PathOf("scenes", scene + ".json")).Scene!);

    [Theory]
    [InlineData("diffuse", 0.1, "path", "no glass or mirror")]
    [InlineData("roughConductor", 0.1, "path", "no glass or mirror")]
    [InlineData("dielectric", 2, "path", "no glass or mirror")]
    [InlineData("dielectric", 0.1, "vcm", "glass or mirrors gather")]
    [InlineData("roughDielectric", 0.1, "vcm", "glass or mirrors gather")]
    [InlineData("conductor", 0.1, "vcm", "glass or mirrors gather")]
    [InlineData("invisible", 0.1, "path", "no glass or mirror")]
    public void Small_lights_and_what_gathers_light_ask_for_vcm(string material, double radius, string integrator, string reason) =>
        AssertAdvice(integrator, reason, Load($$"""{ "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "{{material}}" } }""", radius));

    [Theory]
    [InlineData("dielectric", 4, "vcm", "stands inside glass")]
    [InlineData("dielectric", 1, "path", "no glass or mirror")]
    [InlineData("conductor", 4, "path", "no glass or mirror")]
    public void A_lamp_within_glass_asks_for_vcm_however_large_it_is(string material, double bulb, string integrator, string reason) =>
        AssertAdvice(integrator, reason, Load($$"""{ "type": "sphere", "center": [0, 3, 0], "radius": {{bulb}}, "material": { "type": "{{material}}" } }""", 2));

    private static void AssertAdvice(string integrator, string reason, Scene scene)
    {
        IntegratorAdvice advice = IntegratorAdvice.For(scene);
        Assert.Equal(integrator, advice.Integrator.Name);
        Assert.Contains(reason, advice.Reason, StringComparison.Ordinal);
    }

    private static Scene Load(string shape, double radius)
    {
        string lamp = Lamp.Replace("RADIUS", radius.ToString(System.Globalization.CultureInfo.InvariantCulture), StringComparison.Ordinal);
        return SceneLoader.LoadText($$"""{ "shapes": [{{shape}}], "lights": [{{lamp}}] }""", "scene.json", ".").Scene!;
    }
}
