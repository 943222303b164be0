using System.Text.RegularExpressions;
using RayTracer.Imaging;
using RayTracer.Mutations;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Labs.Tests;

/// <summary>Each lab grades its solution with all points, its starter with none, and recognises its common mistakes.</summary>
public sealed partial class LabTests
{
    private static readonly Lazy<LabVariants> s_variants = new(() => new());

    public static TheoryData<int> Labs => new(Lab.All.Select(l => l.Number));

    public static TheoryData<int, string> Mistakes
    {
        get
        {
            TheoryData<int, string> data = [];
            foreach (Lab lab in Lab.All)
            {
                LabVariants.Mistakes(lab).ToList().ForEach(m => data.Add(lab.Number, m.Name));
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Labs))]
    [Trait("Category", "Thorough")]
    public void A_solution_gets_all_points_whatever_the_name(int number)
    {
        string[] names = [.. Enumerable.Range(0, TestSettings.Scale(12, 40)).Select(i => i == 0 ? "Ada" : $"Student {i}")];
        Parallel.ForEach(names, name => Assert.All(s_variants.Value.Check(Lab.Of(number), LabVariants.Solution, name), f => Assert.True(f.IsRight, $"{name}: {f.Title}: {f.Sentence} {f.Case} {f.Expected} {f.Found}")));
    }

    [Theory]
    [MemberData(nameof(Labs))]
    public void A_starter_gets_no_point_and_is_told_what_is_missing(int number) => Assert.All(
        s_variants.Value.Check(Lab.Of(number), LabVariants.Starter, "Ada"),
        f => Assert.True(!f.IsRight && f.Sentence!.StartsWith("Not written yet: ", StringComparison.Ordinal), $"{f.Title}: {f.Sentence}"));

    [Theory]
    [MemberData(nameof(Mistakes))]
    public void A_common_mistake_is_recognised_by_its_sentence(int number, string name)
    {
        Lab lab = Lab.Of(number);
        (Mutant mistake, int index) = LabVariants.Mistakes(lab).Select((m, i) => (m, i)).Single(m => m.m.Name == name);
        foreach (string student in new[] { "Ada", "Grace", "Alan" })
        {
            Finding? wrong = s_variants.Value.Check(lab, LabVariants.NameOf(index), student).FirstOrDefault(f => f.IsRecognised && f.Sentence!.Contains(mistake.Says!, StringComparison.Ordinal));
            Assert.True(wrong is not null, $"{student} is not told \"{mistake.Says}\"");
            Assert.All(wrong.Exhibits.Where(e => e.Kind == "json"), e =>
            {
                using TemporaryFolder folder = new();
                File.WriteAllBytes(folder["ray.json"], e.Content);
                Assert.Empty(SceneLoader.Load(folder["ray.json"]).Diagnostics);
            });
        }
    }

    [Theory]
    [MemberData(nameof(Labs))]
    public void A_handout_names_its_mistakes_and_its_links_lead_somewhere(int number)
    {
        Lab lab = Lab.Of(number);
        string handout = lab.Text("handout.md");
        IReadOnlyList<Mutant> mistakes = LabVariants.Mistakes(lab);
        Assert.True(mistakes.Count >= 5);
        Assert.All(mistakes, m => Assert.Contains($"- {m.Name}", handout, StringComparison.Ordinal));
        Assert.StartsWith($"# Lab {number}: ", handout, StringComparison.Ordinal);
        HashSet<string> files = [.. lab.Files("").Select(f => f.Replace("starter/", "", StringComparison.Ordinal))];
        Assert.All(Link().Matches(handout).Select(m => m.Groups["target"].Value), target => Assert.Contains(target, files));
        Assert.All(files.Where(f => f.EndsWith(".cs", StringComparison.Ordinal)), f => Assert.Contains(Path.GetFileName(f), handout, StringComparison.Ordinal));
    }

    [Theory]
    [MemberData(nameof(Labs))]
    public void A_starter_is_the_solution_without_what_stands_between_its_marks(int number)
    {
        Lab lab = Lab.Of(number);
        Assert.All(lab.Files("starter/"), f => Assert.DoesNotContain("//?", lab.Text(f), StringComparison.Ordinal));
        string solution = string.Concat(Directory.GetFiles(Path.Combine(LabVariants.FolderOf(lab), "solution")).Select(File.ReadAllText));
        Assert.Equal(Regex.Count(solution, @"^ *//\? ", RegexOptions.Multiline), Regex.Count(solution, "^ *//!$", RegexOptions.Multiline));
        Assert.Equal(Regex.Count(solution, @"^ *//\? ", RegexOptions.Multiline), lab.Files("starter/").Sum(f => Regex.Count(lab.Text(f), "throw new NotImplementedException")));
        Assert.Empty(lab.Files("solution/"));
    }

    [Theory]
    [InlineData(1, "a picture by all of it", "room.png")]
    [InlineData(2, "the tree by surface area", "tests.svg")]
    [InlineData(3, "how errors fall", "errors.svg")]
    [InlineData(4, "strata", "panel.png")]
    [InlineData(5, "a room", "room.png")]
    [InlineData(6, "three balls", "balls.png")]
    [InlineData(7, "a glass ball", "ball.png")]
    [InlineData(8, "a picture", "balls.png")]
    public void A_picture_of_a_handout_is_what_the_solution_makes(int number, string title, string name)
    {
        Exhibit exhibit = s_variants.Value.Check(Lab.Of(number), LabVariants.Solution, "Ada").First(f => f.Title == title).Exhibits[0];
        string path = Path.Combine(LabVariants.FolderOf(Lab.Of(number)), "pictures", name);
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllBytes(path, exhibit.Kind == "png" ? ImageFile.Encode(".png", Own(ImageFile.Decode(exhibit.Content)), new()) : exhibit.Content);
        }

        if (exhibit.Kind == "png")
        {
            // Sines and roots of the system's library may differ in their last digits.
            float[] expected = Own(ImageFile.Decode(exhibit.Content)).Pixels;
            float[] found = ImageFile.Read(path).Pixels;
            Assert.Equal(expected.Length, found.Length);
            Assert.True(expected.Zip(found).Count(p => Math.Abs(p.First - p.Second) > 0.02f) < expected.Length / 1000);
        }
        else
        {
            Assert.True(File.Exists(path));
        }
    }

    // Of a comparison, the first of its three pictures.
    private static Picture Own(Picture comparison)
    {
        if (comparison.Width < 3 * comparison.Height)
        {
            return comparison;
        }

        int width = (comparison.Width - 8) / 3;
        Picture own = new(width, comparison.Height);
        for (int y = 0; y < own.Height; y++)
        {
            comparison.Pixels.AsSpan(3 * y * comparison.Width, 3 * width).CopyTo(own.Pixels.AsSpan(3 * y * width));
        }

        return own;
    }

    // Links to other sites are left out.
    [GeneratedRegex(@"\]\((?<target>[^)#:]+)\)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Link();
}
