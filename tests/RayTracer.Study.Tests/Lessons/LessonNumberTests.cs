using RayTracer.Imaging;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textbook;
using static System.FormattableString;
using Bounds = RayTracer.Textbook.Bounds;
using Rgb = RayTracer.Textbook.Rgb;
using Sphere = RayTracer.Textbook.Sphere;
using Transform = RayTracer.Textbook.Transform;

namespace RayTracer.Study.Tests.Lessons;

/// <summary>Numbers that lessons state are what the formulas beside them give, by the functions of the textbook edition where it has them.</summary>
public sealed class LessonNumberTests
{
    [Fact]
    public void Rays_and_pixels()
    {
        double f = 300 / (2 * Math.Tan(Math.PI * 20 / 180));
        States("21-rays", $"F = 300 / (2 tan 20°) = {f:0}", $"about {f / 3:0}, {f / 6:0}, {f / 12:0} and {f / 24:0} pixels wide", $"300 / 1800: {Degrees(2 * Math.Atan(1.0 / 6)):0.0}°");
    }

    [Fact]
    public void Intersection()
    {
        Sphere ball = new(new(0.6, 0, -3), 1);
        Vector forward = new(0, 0, -1);
        Hit near = Hit.None();
        Hit far = Hit.None();
        Assert.True(ball.Intersect(new(default, forward), ref near) && ball.Intersect(new(new(0, 0, -3), forward), ref far));
        States("22-intersection", $"t_hc = {far.Distance:0.0}: at {near.Distance:0.0} and at {3 + far.Distance:0.0}");
    }

    [Fact]
    public void Transforms()
    {
        Vector house = Transform.Rotation(new(0, 1, 0), -50).After(Transform.Translation(new(2.2, 0, 0))).Point(default);
        States("23-transforms", $"({house.X:0.00}, {house.Z:0.00})");
    }

    [Fact]
    public void Trees()
    {
        double half = new Bounds(default, new(1, 1, 0.5)).Area;
        double whole = new Bounds(default, new(1, 1, 1)).Area;
        States("24-trees", $"a half has the area {half:0}, of {whole:0}, and 4 triangles", $"= {1 + (2 * 4 * half / whole):0.0}, less than 8", $"ten for a thousand, twenty for a million");
        Assert.Equal((10, 20), ((int)Math.Round(Math.Log2(1e3)), (int)Math.Round(Math.Log2(1e6))));
    }

    [Fact]
    public void Microfacets()
    {
        const double Alpha = 0.1;
        Ggx metal = new(new Solid(new Rgb(Alpha)), new Reflectance(Rgb.Black, Rgb.Black, new Solid(Rgb.White)));

        // Straight up, F, both G and both cosines are 1.
        Vector up = new(0, 0, 1);
        double peak = 4 * metal.Evaluate(default, up, up).R;
        States("27-microfacets", $"1/(π α²) = {peak:0}", $"at tan θ = α: {Degrees(Math.Atan(Alpha)):0.0}°");
    }

    [Fact]
    public void Roulette() => States("28-roulette", $"0.7⁵ = {100 * Math.Pow(0.7, 5):0} %", $"0.7⁸ = {100 * Math.Pow(0.7, 8):0.0} %", $"q/(1 − q): four with q = 0.8");

    [Fact]
    public void Environments()
    {
        double zone = 1 - Math.Cos(Math.PI / 512);
        States("29-environments", $"1 − cos(π/512) = {zone * 1e5:0.0}·10⁻⁵ of 2: {zone / 2 * 1e6:0.0}·10⁻⁶", $"once in {Math.Round(Math.PI / 6.8e-5 / 1000):0},000");
        Assert.Equal(200, 1.0 / 512 / (zone / 2), 10.0);
    }

    [Fact]
    public void Media() => States(
        "30-media", $"e^(−3 · 1.2) = {100 * Math.Exp(-3 * 1.2):0.0} %", $"{Math.Pow(0.999, 50):0.00}, {Math.Pow(0.99, 50):0.00}, {Math.Pow(0.95, 50):0.00}: a warm orange");

    [Fact]
    public void Motion() => States("31-motion-blur", $"10/48 m, {1000.0 / 48:0} cm", $"d/s = 1/1.2: {100 / 1.2:0} %");

    [Fact]
    public void Dispersion()
    {
        string Row(Glass glass)
        {
            (double red, double blue) = (Index(glass, 0.656), Index(glass, 0.486));
            return Invariant($"| {red:0.0000} | {Turn(red):0.0}° | {blue:0.0000} | {Turn(blue):0.0}° | {Turn(blue) - Turn(red):0.0}° |");
        }

        double quartz = Index(Glass.FusedQuartz, 0.546);
        States(
            "32-dispersion", $"| BK7, a crown {Row(Glass.Bk7)}", $"| SF11, a dense flint {Row(Glass.Sf11)}", $"{Abbe(Glass.Bk7):0} for BK7, {Abbe(Glass.Sf11):0} for SF11",
            $"at 546 nm is {quartz:0.0000}", $"= {100 * Math.Pow((quartz - 1) / (quartz + 1), 2):0.0} %", $"below {Degrees(Math.Asin(1 / 2.417)):0.0}°");
    }

    [Fact]
    public void Tones()
    {
        Numerics.Rgb shown = ToneMapping.Apply(Description.ToneMap.Reinhard, new(4, 1.4f, 0.32f));
        States(
            "33-tone-mapping", $"A linear 0.5 is written as {SrgbCurve.Encode8(0.5f)}", $"({shown.R:0.00}, {shown.G:0.00}, {shown.B:0.00})",
            $"128 of 255 means {100 * SrgbCurve.Decode8(128):0} %", $"log₂ {Math.Round(1 / SrgbCurve.Decode8(1) / 100) * 100:0}");
    }

    // The lines C, d and F of hydrogen and helium.
    private static double Abbe(Glass glass) => (Index(glass, 0.58756) - 1) / (Index(glass, 0.48613) - Index(glass, 0.65627));

    private static double Index(Glass glass, double micrometres) => glass.Dispersion().Index((float)micrometres)[0];

    // By how much a prism of 60° turns light that goes through symmetrically.
    private static double Turn(double index) => (2 * Degrees(Math.Asin(index / 2))) - 60;

    private static double Degrees(double radians) => radians * 180 / Math.PI;

    private static void States(string lesson, params FormattableString[] texts)
    {
        string page = string.Join(' ', File.ReadAllText(ProjectFolder.PathOf("docs", "primer", $"{lesson}.md")).Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        Assert.All(texts, text => Assert.Contains(Invariant(text), page, StringComparison.Ordinal));
    }
}
