using System.CommandLine;
using RayTracer.Cli;
using RayTracer.Cli.Tests;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>The command lines that the pages show are understood by the program, name files that exist, and run.</summary>
public class CommandsTests
{
    // What is not run: what measures, opens a window, submits jobs, makes folders where it is, or adds up parts that other machines made.
    // The option --root holds for the whole process, and with it for other tests.
    private static readonly HashSet<string> s_notRun = ["bench", "reproduce", "studio", "cluster", "merge", "lab", "--root"];

    // Files of the reader's own that are not made here.
    private static readonly HashSet<string> s_readersOwn = ["model.glb", "scene.xml", "scene.pbrt", "/net/scene.json", "own.dll"];
    private static readonly string[] s_fileTypes = [".json", ".xml", ".png", ".jpg", ".exr", ".rtfilm", ".glb", ".pbrt"];

    // The pages run in their own folders, with a scene and pictures for the names that stand for the reader's.
    private const string Scene = """
        {
          "camera": { "position": [0, 1, 5], "lookAt": [0, 0.5, 0] },
          "render": { "width": 600, "height": 600, "samplesPerPixel": 1024 },
          "background": "skyblue",
          "materials": { "glass": { "type": "dielectric", "refractiveIndex": 1.5 } },
          "shapes": [{ "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5, "material": "glass" }, { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }]
        }
        """;

    public static TheoryData<string> Pages => LinksTests.Pages;

    // The gallery has a command for each shipped scene; its pictures have tests of their own. Caustics take their time.
    public static TheoryData<string> QuickPages =>
        new(LinksTests.Paths.Where(page => TestSettings.Thorough || page is not ("docs/gallery.md" or "docs/light-from-the-lamps.md")));

    [Theory]
    [MemberData(nameof(Pages))]
    public void Commands_of_a_page_are_understood(string page)
    {
        foreach (PageCommand command in Commands(page))
        {
            string? project = command.Project;
            Assert.True(project is null || Directory.Exists(ProjectFolder.PathOf(project)), $"{page}: {command}: there is no project {project}");
            if (command.IsRaytracer)
            {
                ParseResult result = CommandLine.Parse(command.Words, new(TextWriter.Null, TextWriter.Null, HasTerminal: false));
                Assert.True(result.Errors.Count == 0 && CommandLine.Stray(result) is null, $"{page}: {command}: {CommandLine.Stray(result)} {string.Join("; ", result.Errors)}");
            }
        }
    }

    [Theory]
    [MemberData(nameof(QuickPages))]
    [Trait("Category", "Thorough")]
    public void Commands_of_a_page_run(string page)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["scene.json"], Scene);
        File.WriteAllText(folder["x.json"], Scene);
        ImageFile.Write(folder["picture.exr"], new Picture(801, 2));
        ImageFile.Write(folder["image.exr"], new Picture(16, 12));
        foreach (PageCommand command in Commands(page).Where(c => c.IsRaytracer && !c.Words.Any(w => s_notRun.Contains(w) || s_readersOwn.Contains(w))))
        {
            CliRun run = CliRun.Of([.. Smaller(command.Words).Select(w => Placed(w, folder))]);
            Assert.True(run.Status == 0, $"{page}: {command}: {run.Error}{run.Output}");
        }
    }

    [Fact]
    public void Commands_are_found_in_blocks_and_spans_and_end_where_the_shell_ends_them()
    {
        string[] found = [.. PageCommand.Of("""
            Run `raytracer info`, or `raytracer check a.json`:

                raytracer render b.json -o c-####.png   # a comment
                seq 2 | xargs -I{} raytracer render b.json --part {}/2 --quiet > log

            ```
            source <(raytracer completion bash)
            dotnet run -c Release --project src/RayTracer.Cli -- view "c.png"
            ```

            """).Select(c => c.ToString())];
        Assert.Equal(
            [
                "raytracer render b.json -o c-####.png", "raytracer render b.json --part 1/2 --quiet", "raytracer completion bash",
                "dotnet run -c Release --project src/RayTracer.Cli -- view c.png", "raytracer check a.json",
            ],
            found);
    }

    private static PageCommand[] Commands(string page) => [.. PageCommand.Of(File.ReadAllText(ProjectFolder.PathOf(page)).ReplaceLineEndings("\n"))];

    // Files of the repository where they are, all others in the test's folder.
    private static string Placed(string word, TemporaryFolder folder) => word switch
    {
        "." => folder.Path,
        _ when !s_fileTypes.Contains(Path.GetExtension(word)) => word,
        _ when File.Exists(ProjectFolder.PathOf(word)) => ProjectFolder.PathOf(word),
        _ => folder[Path.GetFileName(word)],
    };

    // A few pixels are enough, and one of a large picture is as quick.
    private static IEnumerable<string> Smaller(string[] words) => words[0] is not ("render" or "sweep") || words.Contains("--pixel") ? words
        : words.Where((w, i) => !IsSize(w) && (i == 0 || !IsSize(words[i - 1]))).Concat(["--set", "render.width=8", "--set", "render.height=8"]);

    private static bool IsSize(string word) => word is "--width" or "--height";
}
