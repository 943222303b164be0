using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace RayTracer.Study.Tests.Lessons;

/// <summary>The drawings of the primer's lessons are what the program draws. <c>RAYTRACER_UPDATE=1</c> draws them again.</summary>
public sealed partial class LessonFigureTests
{
    // Sines and powers of the system's library differ in their last digits, and with them what is rounded.
    private const double Tolerance = 0.02;

    private static readonly Dictionary<string, Func<XDocument>> s_figures = new()
    {
        ["camera"] = RayFigures.Camera,
        ["sphere"] = RayFigures.Sphere,
        ["barycentric"] = RayFigures.Barycentric,
        ["transforms"] = RayFigures.Transforms,
        ["trees"] = RayFigures.Trees,
        ["asked"] = RayFigures.Asked,
        ["visibility"] = RayFigures.Visibility,
        ["error"] = ChanceFigures.Error,
        ["means"] = ChanceFigures.Means,
        ["warps"] = ChanceFigures.Warps,
        ["weights"] = ChanceFigures.Weights,
        ["roulette"] = ChanceFigures.Roulette,
        ["lobes"] = LightFigures.Lobes,
        ["environment"] = LightFigures.Environment,
        ["media"] = LightFigures.Media,
        ["shutter"] = LightFigures.Shutter,
        ["index"] = LightFigures.Index,
        ["tones"] = PictureFigures.Tones,
        ["filters"] = PictureFigures.Filters,
    };

    public static TheoryData<string> Names => new(s_figures.Keys);

    [Theory]
    [MemberData(nameof(Names))]
    public void The_drawing_is_what_the_program_draws(string name)
    {
        string path = ProjectFolder.PathOf("docs", "charts", $"lesson-{name}.svg");
        using MemoryStream file = new();
        s_figures[name]().Save(file);
        string drawn = System.Text.Encoding.UTF8.GetString(file.ToArray()).TrimStart('\uFEFF').ReplaceLineEndings("\n");
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllText(path, drawn);
        }

        string kept = File.ReadAllText(path).ReplaceLineEndings("\n");
        Assert.Equal(Number().Replace(kept, "#"), Number().Replace(drawn, "#"));
        Assert.All(Numbers(kept).Zip(Numbers(drawn)), pair => Assert.Equal(pair.First, pair.Second, Tolerance));
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Its_letters_are_large_enough_where_it_is_shown_700_pixels_wide(string name)
    {
        XElement root = XDocument.Load(ProjectFolder.PathOf("docs", "charts", $"lesson-{name}.svg")).Root!;
        double scale = Math.Min(1, 700 / (double)root.Attribute("width")!);
        Assert.All(root.DescendantsAndSelf().Attributes("font-size"), size => Assert.InRange((double)size * scale, 11, 20));
    }

    [Fact]
    public void Every_drawing_is_in_a_lesson()
    {
        string lessons = string.Concat(Directory.GetFiles(ProjectFolder.PathOf("docs", "primer"), "*.md").Select(File.ReadAllText));
        Assert.All(s_figures.Keys, name => Assert.Contains($"](../charts/lesson-{name}.svg)", lessons, StringComparison.Ordinal));
        IEnumerable<string> files = Directory.GetFiles(ProjectFolder.PathOf("docs", "charts"), "lesson-*.svg").Select(f => Path.GetFileNameWithoutExtension(f)["lesson-".Length..]);
        Assert.Equal(s_figures.Keys.Order(StringComparer.Ordinal), files.Order(StringComparer.Ordinal));
    }

    private static IEnumerable<double> Numbers(string svg) => Number().Matches(svg).Select(m => double.Parse(m.Value, System.Globalization.CultureInfo.InvariantCulture));

    [GeneratedRegex(@"-?(?<![\w#])\d+(\.\d+)?(?!\w)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Number();
}
