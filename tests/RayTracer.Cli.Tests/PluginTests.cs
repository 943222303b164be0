using System.Diagnostics;
using System.Globalization;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using System.Reflection.PortableExecutable;
using System.Text.RegularExpressions;

namespace RayTracer.Cli.Tests;

/// <summary>Covers <see cref="PluginOption"/> and the loading behind it, in processes of their own: what is added stays.</summary>
public class PluginTests
{
    private const string Scene = """
        {
          "camera": { "position": [0, 1, 5] },
          "render": { "width": 24, "height": 16, "samplesPerPixel": 4, "integrator": "path", "sampler": "dart" },
          "shapes": [
            { "type": "ball", "center": [0, 0.5, 0], "size": 0.8, "material": { "type": "velvet" } },
            { "type": "plane", "point": [0, -0.5, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "stripes", "count": 3 } } }
          ],
          "lights": [{ "type": "beacon", "position": [0, -0.4, 2], "intensity": [30, 30, 30] }, { "type": "point", "position": [2, 4, 3], "intensity": [50, 50, 50] }]
        }
        """;

    // A scene of the program's own things, any of which may be replaced.
    private const string Native = """
        {
          "camera": { "position": [0, 1, 5], "projection": "perspective" },
          "render": { "width": 8, "height": 6, "samplesPerPixel": 2, "integrator": "path", "sampler": "independent" },
          "background": "skyblue",
          "shapes": [{ "type": "sphere", "center": [0, 1, 0], "material": { "type": "diffuse" } }]
        }
        """;

    private static readonly string s_plugin = Path.Combine(AppContext.BaseDirectory, "RayTracer.SamplePlugin.dll");

    [Fact]
    public void A_scene_of_things_that_only_a_plug_in_knows_is_rendered_into_its_format_with_its_image()
    {
        using TemporaryFolder folder = new();
        string scene = Write(folder, Scene);
        string image = folder["picture.ppm"];

        (int status, string text) = Run("render", scene, "--plugin", s_plugin, "-o", image, "--aov", "nearness", "--quiet");

        Assert.Equal((0, ""), (status, text));
        int[] numbers = [.. File.ReadAllText(image).Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries).Skip(4).Select(int.Parse)];
        Assert.Equal(24 * 16 * 3, numbers.Length);

        // The ball is red all over, and darker where it is seen from the front.
        Assert.All([(12, 8), (12, 5), (10, 7)], p => Assert.True(Red(p.Item1, p.Item2) > 2 * Green(p.Item1, p.Item2), $"no red at {p}"));
        Assert.Contains(Directory.GetFiles(folder.Path), f => f.Contains("nearness", StringComparison.Ordinal));

        int Red(int x, int y) => numbers[3 * ((24 * y) + x)];
        int Green(int x, int y) => numbers[(3 * ((24 * y) + x)) + 1];
    }

    [Fact]
    public void Without_the_plug_in_its_types_are_unknown_and_a_scene_cannot_name_a_file_of_them()
    {
        using TemporaryFolder folder = new();
        (int status, string text) = Run("check", Write(folder, Scene));
        Assert.Equal(3, status);
        Assert.Contains("unknown shape type \"ball\"", text, StringComparison.Ordinal);

        (status, text) = Run("check", Write(folder, Scene.Replace("{\n  \"camera\"", $"{{\n  \"plugin\": \"{s_plugin}\", \"camera\"", StringComparison.Ordinal)));
        Assert.Equal(3, status);
        Assert.Contains("unknown key \"plugin\"", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Values_of_plug_ins_are_held_to_their_ranges()
    {
        using TemporaryFolder folder = new();
        (int status, string text) = Run("check", "--plugin=" + s_plugin, Write(folder, Scene.Replace("0.8", "-1", StringComparison.Ordinal)));
        Assert.Equal(3, status);
        Assert.Contains("\"size\" must be greater than 0, but is -1", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("fast")]
    [InlineData("textbook")]
    public void An_exception_of_a_plug_in_is_told_with_its_class_its_methods_the_pixel_and_the_sample(string edition)
    {
        using TemporaryFolder folder = new();
        string scene = Write(folder, """
            {
              "camera": { "position": [0, 0, 4] },
              "render": { "width": 40, "height": 32, "samplesPerPixel": 4 },
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "ownMatt", "breaksAbove": 0.7 } }],
              "lights": [{ "type": "point", "position": [1, 3, 4], "intensity": [50, 50, 50] }]
            }
            """);
        string plugin = Path.Combine(AppContext.BaseDirectory, "RayTracer.StudentPlugin.dll");
        string[] render = ["render", scene, "--plugin", plugin, "--edition", edition, "--quiet"];

        (int status, string text) = Run([.. render, "-o", folder["picture.png"]]);

        Match told = Regex.Match(text.ReplaceLineEndings("\n"), """
            ^raytracer: error: OwnMatt.Matt, of the plug-in RayTracer.StudentPlugin [\d.]+, threw InvalidOperationException at pixel (\d+),(\d+), sample \d: This is too high
              at OwnMatt.Matt(?: \(OwnMatt.cs:\d+\))?
            (?:  at OwnMatt.Evaluate(?: \(OwnMatt.cs:\d+\))?
            )*$
            """.ReplaceLineEndings("\n"));
        Assert.True(told.Success && status == 4, $"{status}: {text}");

        // Only the top of the ball is so high. There the fast edition breaks again, and nowhere else.
        Assert.InRange(int.Parse(told.Groups[2].Value, CultureInfo.InvariantCulture), 3, 8);
        if (edition == "fast")
        {
            Assert.Equal(4, Run([.. render, "--pixel", $"{told.Groups[1].Value},{told.Groups[2].Value}"]).Status);
            Assert.Equal(0, Run([.. render, "--pixel", "20,16"]).Status);
        }
    }

    [Theory]
    [InlineData("explain", "velvet")]
    [InlineData("reference")]
    [InlineData("schema")]
    public void Types_of_plug_ins_are_explained_as_the_program_s_own(params string[] words)
    {
        (int status, string text) = Run([.. words, "--plugin", s_plugin]);
        Assert.Equal(0, status);
        Assert.Contains("velvet", text, StringComparison.Ordinal);
        Assert.Contains("seen from the side", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("light", "error: no light paths can start at a light source without a name, as the integrator light needs")]
    [InlineData("photons", "error: no light paths can start at a light source without a name, as the integrator photons needs")]
    [InlineData("vcm", null)]
    public void A_light_of_a_plug_in_is_refused_where_all_its_light_would_have_to_come_from_there(string integrator, string? error)
    {
        using TemporaryFolder folder = new();
        string scene = Write(folder, Scene.Replace("\"path\"", $"\"{integrator}\"", StringComparison.Ordinal));
        (int status, string text) = Run("check", scene, "--plugin", s_plugin);
        Assert.Equal(error is null ? 0 : 3, status);
        Assert.Contains(error ?? "", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Scenes_with_things_of_plug_ins_are_converted_and_described()
    {
        using TemporaryFolder folder = new();
        string scene = Write(folder, Scene);
        Assert.Equal((0, ""), Run("convert", scene, folder["again.json"], "--plugin", s_plugin));
        Assert.Contains("\"velvet\"", File.ReadAllText(folder["again.json"]), StringComparison.Ordinal);
        (int status, string text) = Run("info", scene, "--plugin", s_plugin);
        Assert.Equal(0, status);
        Assert.Contains("ball", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"velvet\"", "\"diffuse\"")]
    [InlineData("\"integrator\": \"headlight\"", "\"integrator\": \"path\"")]
    [InlineData("\"sampler\": \"dart\"", "\"sampler\": \"independent\"")]
    [InlineData("\"projection\": \"fisheye\"", "\"projection\": \"perspective\"")]
    public void A_film_is_resumed_with_the_same_version_of_a_plug_in_only(string thing, string native)
    {
        using TemporaryFolder folder = new();
        string next = folder["next.dll"], film = folder["a.rtfilm"];
        File.WriteAllBytes(next, WithVersion(File.ReadAllBytes(s_plugin), TableIndex.Assembly, null, 2));
        string scene = Write(folder, Native.Replace(native, thing, StringComparison.Ordinal));

        Assert.Equal((0, ""), Run("render", scene, "--plugin", s_plugin, "-o", film, "--spp", "2", "--quiet"));
        Assert.Equal((0, ""), Run("resume", film, "--plugin", s_plugin, "--spp", "4", "--quiet"));
        (int status, string text) = Run("resume", film, "--plugin", next, "--spp", "6", "--quiet");
        Assert.Equal(4, status);
        Assert.Contains("its settings, a plug-in or the program are others than they were", text, StringComparison.Ordinal);
        Assert.Contains("unknown ", Run("resume", film, "--spp", "6", "--quiet").Text, StringComparison.Ordinal);
    }

    [Fact]
    public void A_film_without_things_of_a_plug_in_is_resumed_whatever_its_version()
    {
        using TemporaryFolder folder = new();
        string next = folder["next.dll"], film = folder["a.rtfilm"];
        File.WriteAllBytes(next, WithVersion(File.ReadAllBytes(s_plugin), TableIndex.Assembly, null, 2));
        Assert.Equal((0, ""), Run("render", Write(folder, Native), "--plugin", s_plugin, "-o", film, "--spp", "2", "--quiet"));
        Assert.Equal((0, ""), Run("resume", film, "--plugin", next, "--spp", "4", "--quiet"));
    }

    [Fact]
    public void A_sweep_shows_things_of_a_plug_in_side_by_side()
    {
        using TemporaryFolder folder = new();
        string sheet = folder["sheet.ppm"];
        (int status, string text) = Run("sweep", Write(folder, Native), "--set", "render.integrator=path,headlight", "--plugin", s_plugin, "-o", sheet, "--json");
        Assert.Equal(0, status);
        Assert.Contains("headlight", text, StringComparison.Ordinal);
        Assert.StartsWith("P3", File.ReadAllText(sheet), StringComparison.Ordinal);
    }

    [Fact]
    public void What_is_no_plug_in_is_refused_in_one_sentence()
    {
        using TemporaryFolder folder = new();
        string scene = Write(folder, Scene);
        string old = folder["old.dll"];
        File.WriteAllBytes(old, WithVersion(File.ReadAllBytes(s_plugin), TableIndex.AssemblyRef, "RayTracer.Core", 9));

        Refused([scene], "this is no .NET assembly");
        Refused([folder["missing.dll"]], "cannot be loaded: ");
        Refused([Path.Combine(AppContext.BaseDirectory, "xunit.assert.dll")], "xunit.assert has no types for scenes");
        Refused([old], "was made for version 9.9.9.9 of RayTracer.Core, but this is ");
        Refused([s_plugin, s_plugin], " of RayTracer.SamplePlugin needs another name: there is one already");

        void Refused(string[] files, string message)
        {
            (int status, string text) = Run(["check", scene, .. files.SelectMany(f => new[] { "--plugin", f })]);
            Assert.Equal(4, status);
            Assert.Contains(message, Assert.Single(text.Trim().Split('\n')), StringComparison.Ordinal);
        }
    }

    // The same assembly, but for the version that it has, or that it names of another one: all four parts are a number.
    private static byte[] WithVersion(byte[] assembly, TableIndex table, string? reference, ushort number)
    {
        using PEReader file = new(new MemoryStream(assembly));
        MetadataReader metadata = file.GetMetadataReader();
        int row = reference is null ? 0
            : MetadataTokens.GetRowNumber(metadata.AssemblyReferences.First(r => metadata.GetString(metadata.GetAssemblyReference(r).Name) == reference)) - 1;
        int start = file.PEHeaders.MetadataStartOffset + metadata.GetTableMetadataOffset(table) + (row * metadata.GetTableRowSize(table));
        for (int part = 0; part < 4; part++)
        {
            // A row of Assembly begins with the kind of its hash (ECMA-335, II.22.2).
            BitConverter.TryWriteBytes(assembly.AsSpan(start + (table == TableIndex.Assembly ? 4 : 0) + (2 * part)), number);
        }

        return assembly;
    }

    private static string Write(TemporaryFolder folder, string scene)
    {
        File.WriteAllText(folder["scene.json"], scene);
        return folder["scene.json"];
    }

    // What a command says on both of its streams.
    private static (int Status, string Text) Run(params string[] words)
    {
        using Process process = ProcessTests.Start(words);
        Task<string> error = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, output + error.Result);
    }
}
