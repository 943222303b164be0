using System.Xml.Linq;
using RayTracer.Cli;
using RayTracer.Cli.Reproduce;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests.Reproduce;

public sealed class ReproductionTests : IDisposable
{
    private static readonly ReproductionPlan Tiny = new(50, 4, [1, 4, 9, 16], 1);
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Small_run_writes_all_pictures_chart_and_pages()
    {
        string folder = _folder["new/deeper"];
        using StringWriter output = new();
        using StringWriter error = new();
        int status = new Reproduction(Tiny, folder, "raytracer x", new(output, error)).Run();
        Assert.Equal((0, ""), (status, error.ToString()));
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
        }
    }

    [Fact]
    public void Scenes_have_what_table_6_1_says()
    {
        using StringWriter output = new();
        Assert.Equal(0, new Reproduction(Tiny, _folder.Path, "raytracer x", new(output, output)).Run());
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

    [Fact]
    public void File_in_place_of_the_folder_is_an_error()
    {
        string file = _folder["file"];
        File.WriteAllText(file, "x");
        CliRun run = CliRun.Of("reproduce", "report", "--quick", "-o", file);
        Assert.Equal((4, ""), (run.Status, run.Output));
        Assert.Contains("is a file, but a folder is expected", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
        run = CliRun.Of("reproduce", "report", "--quick", "-o", Path.Combine(file, "below"));
        Assert.Equal(4, run.Status);
        Assert.Contains("cannot be made", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
        Assert.Equal("x", File.ReadAllText(file));
    }

    [Fact]
    public void Folder_in_place_of_a_file_is_an_error_before_the_work()
    {
        Directory.CreateDirectory(_folder["index.md"]);
        CliRun run = CliRun.Of("reproduce", "report", "--quick", "-o", _folder.Path);
        Assert.Equal((4, ""), (run.Status, run.Output));
        Assert.Single(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Wrong_usage_is_told()
    {
        Assert.Equal(2, CliRun.Of("reproduce").Status);
        Assert.Contains("-o FOLDER", CliRun.Of("reproduce", "report").Error, StringComparison.Ordinal);
        CliRun run = CliRun.Of("reproduce", "reprot", "-o", _folder.Path);
        Assert.Equal(2, run.Status);
        Assert.Contains("did you mean \"report\"?", run.Error, StringComparison.Ordinal);
    }
}
