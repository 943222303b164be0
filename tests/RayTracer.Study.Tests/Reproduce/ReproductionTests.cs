using System.Net;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Study.Tests;

public sealed class ReproductionTests : IDisposable
{
    private static readonly ReproductionPlan Tiny = new(50, 4, [1, 4, 9, 16], 1, 0.001);
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Small_run_writes_all_pictures_chart_and_pages()
    {
        string folder = _folder["new/deeper"];
        Run(folder);
        string[] pictures = [.. ReportScene.All.SelectMany(s => s.Pictures.Select(s.PictureFile))];
        Assert.Equal(10, pictures.Length);
        string[] expected = [.. pictures, "figure-6-6.svg", "index.html", "index.md"];
        Assert.Equal(expected.Order(StringComparer.Ordinal), Directory.GetFiles(folder).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        Picture last = ImageFile.Read(Path.Combine(folder, "figure-6-5-c.png"));
        Assert.Equal((6, 6), (last.Width, last.Height));
        Assert.Contains(new("Samples", "100"), ImageFile.ReadText(Path.Combine(folder, "figure-6-5-c.png")));
        XDocument chart = XDocument.Load(Path.Combine(folder, "figure-6-6.svg"));
        Assert.Equal((3 * Tiny.ChartSamples.Count) + pictures.Length, chart.Descendants().Count(e => e.Name.LocalName == "circle"));
        foreach (string page in new[] { "index.md", "index.html" })
        {
            string text = File.ReadAllText(Path.Combine(folder, page));
            Assert.Contains("quick run", text, StringComparison.Ordinal);
            Assert.DoesNotContain(Environment.MachineName, text, StringComparison.Ordinal);
            Assert.All(pictures, p => Assert.Contains(p, text, StringComparison.Ordinal));
            Assert.Contains("2119.853", text, StringComparison.Ordinal);
            string plain = WebUtility.HtmlDecode(text);
            Assert.Equal((3, 3), (Regex.Count(plain, "[>|] ?100×100"), Regex.Count(plain, "[>|] ?800×600")));
            Assert.Matches($"Date.*{DateTime.UtcNow.Year}-", text);
        }
    }

    [Fact]
    public void Scenes_have_what_table_6_1_says()
    {
        Run(_folder.Path);
        string[] rows = [.. File.ReadLines(_folder["index.md"]).Where(l => l.EndsWith("| yes |", StringComparison.Ordinal))];
        Assert.Equal(["| 1 | 2 (2) | 4 (4) | 600×600 (600×600) | yes |", "| 2 | 9 (9) | 4 (4) | 600×600 (600×600) | yes |", "| 3 | 9 (9) | 4 (4) | 300×300 (300×300) | yes |"], rows);
    }

    [Fact]
    public void Speed_up_compares_path_for_path()
    {
        ReportScene scene = ReportScene.All[0];
        ReportPicture picture = scene.Pictures[0];
        Measurement half = new(scene, scene.Size / 2, picture.SamplesPerPixel, 1, picture.Seconds / 40, 1);
        Assert.Equal(10, new ReproducedPicture(scene, picture, half, half).SpeedUp(half), 1e-9);
    }

    [Fact]
    public void Plans_keep_samples_square_and_have_enough_points()
    {
        foreach (ReproductionPlan plan in new[] { ReproductionPlan.Full, ReproductionPlan.Quick, Tiny })
        {
            IEnumerable<int> samples = ReportScene.All.SelectMany(s => s.Pictures).Select(plan.Samples).Concat(plan.ChartSamples);
            Assert.All(samples, n => Assert.Equal(0, Math.Sqrt(n) % 1));
            Assert.True(plan.ChartSamples.Count >= 4);
        }
    }

    private static void Run(string folder)
    {
        using StringWriter output = new();
        Reports reports = new();
        new Reproduction(Tiny, folder, output, reports).Run(CancellationToken.None);
        Assert.Empty(reports.Lines);
    }

    private sealed class Reports : IJobWatch
    {
        public List<string> Lines { get; } = [];

        public void Warn(string message) => Lines.Add(message);

        public void Fail(string message) => Lines.Add(message);

        public void Read(IReadOnlyList<Diagnostic> diagnostics) => Lines.AddRange(diagnostics.Select(d => d.Message));
    }
}
