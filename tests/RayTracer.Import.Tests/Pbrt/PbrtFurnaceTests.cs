using RayTracer.Rendering;

namespace RayTracer.Import.Tests;

/// <summary>
/// pbrt's own scenes with a known answer, from their description: from the middle of a sphere of radius 1, a radiance of 1 is seen everywhere, since what is
/// emitted and what is reflected of all of it add up so.
/// Covers `PbrtLights`, `PbrtShapes`, `PbrtMaterials`.
/// </summary>
public class PbrtFurnaceTests
{
    private const string Film = """Film "rgb" "integer xresolution" 10 "integer yresolution" 10 PixelFilter "box" Sampler "zsobol" "integer pixelsamples" 64 """;
    private const string Perspective = """Camera "perspective" "float fov" 45 """;
    private const string Orthographic = """Camera "orthographic" "float screenwindow" [-0.1 0.1 -0.1 0.1] """;
    private const string Matt = """Material "diffuse" "rgb reflectance" [0.5 0.5 0.5] """;

    // A quarter matt and half a mirror. What a mirror throws back to the point light's place reaches the wall again, but no path finds it there.
    private const string Glossy = """
        MakeNamedMaterial "matt" "string type" "diffuse" "rgb reflectance" [0.5 0.5 0.5]
        MakeNamedMaterial "mirror" "string type" "conductor" "rgb reflectance" [1 1 1]
        Material "mix" "string materials" ["matt" "mirror"] "float amount" 0.5
        """ + "\n";

    private const string Sphere = "ReverseOrientation Shape \"sphere\" \"float radius\" 1 ";
    private const string Point = """LightSource "point" "rgb I" [3.14159265 3.14159265 3.14159265] """;
    private const string Quarter = """LightSource "point" "rgb I" [1 1 1] "float scale" 0.785398163 """;
    private const string Powered = """LightSource "point" "float power" 39.4784176 """;

    public static TheoryData<string, string, string> Scenes => new()
    {
        { "a point light", Perspective, Point + Matt + Sphere },
        { "a point light of a power", Perspective, Powered + Matt + Sphere },
        { "a spectral point light", Perspective, """LightSource "point" "spectrum I" [360 7 830 7] "float scale" 3.14159265 """ + Matt + Sphere },
        { "four point lights", Perspective, Quarter + Quarter + Quarter + Quarter + Matt + Sphere },
        { "a wall that shines", Perspective, Matt + """AreaLightSource "diffuse" "rgb L" [0.5 0.5 0.5] """ + Sphere },
        { "a wall of a power", Perspective, Matt + """AreaLightSource "diffuse" "float power" 19.7392088 """ + Sphere },
        { "a point light, seen straight", Orthographic, Point + Matt + Sphere },
        { "a point light before a wall half a mirror", Perspective, Point + Glossy + Sphere },
        { "a shining wall half a mirror", Perspective, Glossy + """AreaLightSource "diffuse" "rgb L" [0.25 0.25 0.25] """ + Sphere },
        { "a cube that shines", Perspective, Matt + """AreaLightSource "diffuse" "rgb L" [0.5 0.5 0.5] """ + Cube() },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_radiance_of_1_is_seen_in(string what, string camera, string things)
    {
        foreach (string integrator in new[] { "path", "volpath" })
        {
            Film film = PbrtTestScene.Render(things, $"{Film}{camera}Integrator \"{integrator}\" \"integer maxdepth\" 100");
            double mean = Enumerable.Range(0, 100).Average(i => (double)film.Mean(i % 10, i / 10).Luminance);
            Assert.True(mean is > 0.99 and < 1.01, $"{what} with {integrator}: {mean}");
        }
    }

    // As pbrt scales light: a film of twice the sensitivity, half as long.
    [Fact]
    public void Sensitivity_and_time_scale_what_is_seen()
    {
        Film film = PbrtTestScene.Render(
            Point + Matt + Sphere, $"{Film.Replace("PixelFilter", "\"float iso\" 400 PixelFilter", StringComparison.Ordinal)}Camera \"perspective\" \"float shutterclose\" 0.5 Integrator \"path\" \"integer maxdepth\" 100");
        Assert.InRange(film.Mean(5, 5).G, 1.9, 2.1);
    }

    // Six squares whose fronts are inside.
    private static string Cube()
    {
        string[] faces = ["-1 -1 -1 -1 -1 1 -1 1 -1 -1 1 1", "1 -1 -1 1 1 -1 1 -1 1 1 1 1", "-1 -1 -1 1 -1 -1 -1 -1 1 1 -1 1", "-1 1 -1 -1 1 1 1 1 -1 1 1 1", "-1 -1 -1 -1 1 -1 1 -1 -1 1 1 -1", "-1 -1 1 1 -1 1 -1 1 1 1 1 1"];
        return string.Concat(faces.Select(f => $"ReverseOrientation Shape \"bilinearmesh\" \"point3 P\" [{f}] ReverseOrientation "));
    }
}
