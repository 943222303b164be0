using System.Diagnostics;
using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

/// <summary>Renders that end as nobody wants them to.</summary>
[Trait("Category", "Thorough")]
public sealed class KilledRenderTests : IDisposable
{
    private const int Patience = 60_000;
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;
    private readonly string _film;

    public KilledRenderTests()
    {
        _scene = _folder["scene.json"];
        _film = _folder["film.rtfilm"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [LinuxFact]
    public void A_render_that_is_killed_again_and_again_comes_to_the_bits_of_one_that_is_not()
    {
        Random random = new(TestSettings.Seed);
        int kills = TestSettings.Scale(2, 50);
        int samples = 0;
        for (int i = 0; i < kills; i++)
        {
            DateTime before = i == 0 ? default : File.GetLastWriteTimeUtc(_film);
            string[] words = i == 0 ? ["render", _scene, "--spp", "16777216", "--checkpoint", _film] : ["resume", _film];
            using Process process = ProcessTests.Start([.. words, "--checkpoint-interval", "0", "--quiet"]);
            try
            {
                Assert.True(SpinWait.SpinUntil(() => File.Exists(_film) && File.GetLastWriteTimeUtc(_film) > before, Patience), "no checkpoint came");
                Thread.Sleep(random.Next(100));
            }
            finally
            {
                process.Kill();
                process.WaitForExit();
            }

            // Whatever it was about, the file is whole, and nothing of it was lost.
            FilmHeader header = FilmFile.Read(_film).Header;
            Assert.True(Assert.Single(header.Samples).End >= samples);
            samples = header.Samples[0].End;
        }

        string resumed = CliRun.FilmHash("resume", _film, "--spp", $"{samples + 3}", "--json", "--quiet");
        Assert.Equal(CliRun.FilmHash("render", _scene, "--spp", $"{samples + 3}", "--json", "--quiet"), resumed);
    }

    [RootFact]
    public void A_full_disk_costs_no_film_that_was_there_before()
    {
        string disk = Directory.CreateDirectory(_folder["disk"]).FullName;
        Assert.Equal(0, ProgramFactAttribute.Run("mount", "-t", "tmpfs", "-o", "size=20k", "tmpfs", disk).ExitCode);
        try
        {
            string film = Path.Combine(disk, "film.rtfilm");
            Assert.Equal(0, CliRun.Of("render", _scene, "-o", film, "--quiet").Status);
            byte[] before = File.ReadAllBytes(film);
            string other = Path.Combine(disk, "other.rtfilm");
            foreach (string[] words in new string[][]
            {
                ["resume", film, "--spp", "9", "--quiet"], ["merge", film, "-o", other, "--quiet"], ["render", _scene, "--checkpoint", other, "--quiet"],
                ["render", _scene, "--width", "60", "--height", "40", "-o", Path.Combine(disk, "image.pfm"), "--quiet"],
            })
            {
                CliRun run = CliRun.Of(words);
                Assert.Equal(4, run.Status);
                Assert.Contains("No space left on device", run.Error, StringComparison.Ordinal);
                Assert.Equal(before, File.ReadAllBytes(film));
                Assert.Equal([film], Directory.GetFileSystemEntries(disk));
            }
        }
        finally
        {
            ProgramFactAttribute.Run("umount", disk);
        }
    }
}
