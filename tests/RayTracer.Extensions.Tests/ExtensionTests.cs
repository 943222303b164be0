using System.Numerics;
using System.Runtime.CompilerServices;
using System.Text.Json.Nodes;
using RayTracer.Cli.Tests;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Materials;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Session;
using RayTracer.Shapes;
using RayTracer.Textures;
using JsonNode = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Extensions.Tests;

/// <summary>Things that this assembly defines, one file each, in scenes that the library and the command render.</summary>
public sealed class ExtensionTests : IDisposable
{
    private const int Size = 32;
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public ExtensionTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, $$"""
            {
              "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "render": { "integrator": "report", "width": {{Size}}, "height": {{Size}}, "samplesPerPixel": 1, "sampler": "regular" },
              "background": "skyblue",
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1.5, "material": { "type": "luminaire", "multiplier": 0.5 } }]
            }
            """);
    }

    [ModuleInitializer]
    internal static void Register() => Plugins.Add(typeof(ExtensionTests).Assembly);

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void The_library_renders_an_image_and_writes_and_reads_a_format_of_another_assembly()
    {
        Scene scene = SceneLoader.Load(_scene).Scene!;
        AovFilm images = new(new(Size, Size), [new FacingImage()]);
        new FirstHitPass(scene).Render(images);
        double[] row = new double[Size];
        int met = 0;
        for (int y = 0; y < Size; y++)
        {
            images.ReadRow(new FacingImage(), y, row);
            for (int x = 0; x < Size; x++)
            {
                double expected = Facing(x, y);
                met += expected >= 0 ? 1 : 0;
                Assert.True(Math.Abs(expected - row[x]) < 1e-3 || Math.Abs(expected) < 0.1, $"pixel {x}, {y}: expected {expected}, found {row[x]}");
            }
        }

        Assert.InRange(met, 100, Size * Size);
        Picture picture = new(Size, Size);
        new AovPicture(images, new FacingImage()).ReadRow(Size / 2, picture.Pixels);
        ImageFile.Write(_folder["a.ppm"], picture);
        File.Move(_folder["a.ppm"], _folder["a"]);
        Assert.All(ImageFile.Read(_folder["a"]).Pixels.Zip(picture.Pixels), p => Assert.Equal(p.Second, p.First, 0.01));
        Assert.Equal("a PPM picture", ImageFile.FormatOf(_folder["a"])?.FileName);
    }

    [Fact]
    public void The_command_writes_and_reads_them_like_its_own()
    {
        CliRun run = CliRun.Fine("render", _scene, "-o", _folder["a.ppm"], "-o", _folder["a.exr"], "--aov", "facing", "--exposure", "1", "--quiet");
        Assert.Equal("", run.Error);
        Picture shown = ImageFile.Read(_folder["a.ppm"]), linear = ImageFile.Read(_folder["a.exr"]);
        Assert.All(shown.Pixels.Zip(linear.Pixels), p => Assert.Equal(Math.Min(1, 2 * p.Second), p.First, 0.01));
        Assert.Equal(Facing(14, 14), ExrReader.ReadChannel(File.ReadAllBytes(_folder["a.exr"]), "facing.Y")[(14 * Size) + 14], 1e-3);
        Assert.Equal(Facing(14, 14), ImageFile.Read(_folder["a.facing.ppm"], raw: true).Pixels[3 * ((14 * Size) + 14)], 0.01);
        Assert.Contains($"PPM, {Size}×{Size} pixels", CliRun.Fine("info", _folder["a.ppm"]).Output, StringComparison.Ordinal);
        CliRun.Fine("convert", _folder["a.ppm"], _folder["b.png"]);
        Assert.Equal(shown.Pixels, ImageFile.Read(_folder["b.png"]).Pixels);
    }

    [Fact]
    public void Help_and_messages_name_them()
    {
        string help = string.Join(' ', CliRun.Fine("render", "--help").Output.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        Assert.Contains(".exr, .hdr or .ppm;", help, StringComparison.Ordinal);
        Assert.Contains("PNG, JPEG and PPM: stops", help, StringComparison.Ordinal);
        Assert.Contains("error, facing, ", help, StringComparison.Ordinal);
        CliRun.Refused(2, "(did you mean '.ppm'?)", "render", _scene, "-o", _folder["a.pppm"]);
        CliRun.Refused(2, "(did you mean \"facing\"?)", "render", _scene, "-o", _folder["a.ppm"], "--aov", "facin");
        CliRun.Refused(2, "a PPM picture has at most 9999 pixels a side", "render", _scene, "-o", _folder["a.ppm"], "--width", "10000", "--height", "1");
        Assert.Contains("--bit-depth has no effect", CliRun.Of("render", _scene, "-o", _folder["a.ppm"], "--bit-depth", "16").Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_scene_file_names_an_integrator_a_sampler_and_a_projection_of_another_assembly()
    {
        string[] seen = ["", "fisheye"];
        Film[] films = [.. seen.Select(projection => new RTracer(SceneLoader.Load(WriteScene(projection, "lattice", 16)).Scene!).Render().Film)];
        Assert.NotEqual(films[0].ComputeHash(), films[1].ComputeHash());

        // The sphere has an angular radius of asin(1.5 / 5) = 17.46 degrees, of 90 over the height: 6.2 pixels.
        (int middle, int edge) = (Size / 2, (Size / 2) - 6);
        float[] row = new float[3 * Size];
        float[] column = [.. Enumerable.Range(0, Size).Select(y =>
        {
            films[1].ReadRow(y, row);
            return row[3 * middle];
        })];
        Assert.InRange(column[middle], 0.48f, 0.5f);
        Assert.All(Enumerable.Range(edge + 1, 10), y => Assert.InRange(column[y], 0.05f, 0.5f));
        Assert.All(Enumerable.Range(0, edge - 1), y => Assert.Equal(0, column[y]));
    }

    [Fact]
    public void Their_names_are_understood_whatever_their_case_and_are_in_schema_help_and_suggestions()
    {
        CliRun.Fine("render", WriteScene("FishEye", "LATTICE", 4), "-o", _folder["a.png"], "--integrator", "HeadLight", "--quiet");
        CliRun.Refused(2, "(did you mean \"headlight\"?)", "render", _scene, "-o", _folder["a.png"], "--integrator", "headligth");
        CliRun.Refused(2, "a lattice needs at least 2 samples", "render", _scene, "-o", _folder["a.png"], "--sampler", "lattice");
        Assert.Contains("at least 2 samples", string.Join('\n', SceneLoader.Load(WriteScene("fisheye", "lattice", 1)).Diagnostics), StringComparison.Ordinal);
        Assert.All(["headlight", "lattice", "fisheye"], name => Assert.Contains($"\"{name}\"", SceneSchema.Generate(), StringComparison.Ordinal));
        Assert.All(["headlight", "lattice", "fisheye"], name => Assert.Contains($"\"{name}\"", SceneReference.Generate(), StringComparison.Ordinal));
    }

    [Fact]
    public void What_an_integrator_does_not_show_is_warned_of()
    {
        string file = WriteScene("fisheye", "lattice", 4);
        File.WriteAllText(file, File.ReadAllText(file).Replace("\"background\": \"black\"", "\"background\": \"black\", \"ambient\": [1, 1, 1]", StringComparison.Ordinal));
        Assert.Contains("\"ambient\" has no effect with the integrator headlight: leave it out, or write \"integrator\": \"report\"", string.Join('\n', SceneLoader.Load(file).Diagnostics), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("light")]
    [InlineData("bidirectional")]
    [InlineData("photons")]
    [InlineData("vcm")]
    public void A_projection_that_does_not_say_where_points_are_seen_is_refused_by_integrators_that_trace_light(string integrator)
    {
        string file = WriteScene("fisheye", "independent", 4);
        File.WriteAllText(file, File.ReadAllText(file).Replace("headlight", integrator, StringComparison.Ordinal).Replace("black", "white", StringComparison.Ordinal));
        SceneLoadResult result = SceneLoader.Load(file);
        string message = Assert.Single(result.Diagnostics).ToString();
        Assert.Contains($": error: the integrator {integrator} asks where points are seen, which the projection \"fisheye\" does not say: write", message, StringComparison.Ordinal);
        Assert.Null(result.Scene);
    }

    [Fact]
    public void The_Studio_offers_them()
    {
        Assert.Contains(PictureSaver.Formats, f => f is { Value: "ppm", Label: "PPM", HasDepth: false, HasLayers: false, IsFilm: false });
        Assert.Contains(TypeCatalogue.Instance.Maps, m => m is { Name: "facing", Title: "Facing", IsLight: false });
        Assert.IsType<FacingImage>(ViewMap.Named("facing").Image);
    }

    [Fact]
    public void Names_that_are_taken_are_refused()
    {
        ArgumentException image = Assert.Throws<ArgumentException>(() => AuxiliaryImage.Known.Add(new FacingImage()));
        Assert.StartsWith("There is another auxiliary image \"facing\": RayTracer.Extensions.Tests.FacingImage needs another name.", image.Message);
        ArgumentException format = Assert.Throws<ArgumentException>(() => ImageFormat.Known.Add(new PpmFormat()));
        Assert.StartsWith("There is another image format \"PPM\": RayTracer.Extensions.Tests.PpmFormat needs another name.", format.Message);
        Assert.Single(ImageFormat.Known.All, f => f.Name == "PPM");
    }

    [Theory]
    [InlineData("[0, 0, 0.5, 1]", "")]
    [InlineData("[0, 2, 0, 1]", "a.json:1:109: error: \"turn\" must be from -1 to 1, but is 2")]
    [InlineData("[0, 0, 1]", "a.json:1:105: error: expected 4 numbers for \"turn\", but found 3")]
    [InlineData("\"up\"", "a.json:1:105: error: expected an array of 4 numbers for \"turn\", but found a string")]
    public void A_parameter_of_a_kind_of_another_assembly_is_read_or_refused_at_its_place(string turn, string message)
    {
        SceneReadResult read = SceneReader.ReadText(TurnedScene(turn), "a.json");
        Assert.Contains(message, string.Join('\n', read.Diagnostics.Select(d => d.ToString()).DefaultIfEmpty("")), StringComparison.Ordinal);
        if (message.Length == 0)
        {
            Assert.Empty(read.Diagnostics);
            Assert.Equal(new Quaternion(0, 0, 0.5f, 1), Turned(read).Turn);
            Assert.Equal(Turned(read), Turned(SceneReader.ReadText(SceneWriter.Write(read.Description!), "b.json")));
        }
    }

    [Fact]
    public void A_kind_of_parameter_of_another_assembly_is_documented_shown_and_moved_by_tracks()
    {
        Assert.Contains("| `turn` | [x, y, z, w] |  | from -1 to 1 | `[0, 0, 0, 1]` |", SceneReference.Generate(), StringComparison.Ordinal);
        Assert.Contains("[x, y, z, w]", SceneExplanation.Of("turned.turn"), StringComparison.Ordinal);
        JsonNode schema = JsonNode.Parse(SceneSchema.Generate())!["$defs"]!["texture.turned"]!["properties"]!["turn"]!;
        Assert.Equal(("array", 4, -1), ((string)schema["type"]!, (int)schema["maxItems"]!, (int)schema["items"]!["minimum"]!));
        Assert.Contains(TypeCatalogue.Instance.Types["texture"].Single(t => t.Name == "turned").Parameters, p => p is { Key: "turn", Kind: "quaternion" });
        SceneReadResult moved = SceneReader.ReadText(
            TurnedScene("[0, 0, 0, 1]", """, "animation": [{ "property": "textures.t.turn", "keys": [{ "time": 0, "value": [0, 0, 0, 1] }, { "time": 1, "value": [0, 0, 0, 3] }] }]"""),
            "a.json");
        Assert.Contains("\"turn\" must be from -1 to 1, but is 3", string.Join('\n', moved.Diagnostics), StringComparison.Ordinal);
    }

    [Fact]
    public void A_value_of_a_kind_of_another_assembly_counts_in_the_hash_of_a_scene_and_is_in_range_from_code()
    {
        string Hash(string turn) => ContentHash.Of(SceneReader.ReadText(TurnedScene(turn), "a.json").Description!, _scene, null);
        Assert.Equal(Hash("[0, 0, 0.5, 1]"), Hash("[0, 0, 5e-1, 1]"));
        Assert.Equal(4, new[] { "[0, 0, 0.5, 1]", "[0, 0.5, 0, 1]", "[0, 0, 0, 1]", "[-0, 0, 0, 1]" }.Select(Hash).Distinct().Count());
        SceneDescription scene = new() { Shapes = [new SphereDescription { Material = new DiffuseMaterialDescription { Color = new TurnedDescription { Turn = new(0, 0, 0, 2) } } }] };
        Assert.Contains("\"turn\" must be from -1 to 1, but is 2", Assert.Throws<SceneException>(() => Scene.From(scene)).Message, StringComparison.Ordinal);
    }

    private static TurnedDescription Turned(SceneReadResult read) => (TurnedDescription)read.Description!.Textures["t"];

    private static string TurnedScene(string turn, string more = "") =>
        $$"""{ "shapes": [{ "type": "sphere", "center": [0, 0, 0] }], "textures": { "t": { "type": "turned", "turn": {{turn}} } }{{more}} }""";

    private string WriteScene(string projection, string sampler, int samples)
    {
        string file = _folder[$"{projection}.json"];
        string named = projection.Length > 0 ? $", \"projection\": \"{projection}\"" : "";
        File.WriteAllText(file, $$"""
            {
              "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 90{{named}} },
              "render": { "width": {{Size}}, "height": {{Size}}, "samplesPerPixel": {{samples}}, "sampler": "{{sampler}}", "integrator": "headlight" },
              "background": "black",
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1.5, "material": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } }]
            }
            """);
        return file;
    }

    // The cosine at the sphere's point in the middle of a pixel; -1 beside it.
    private static double Facing(int x, int y)
    {
        double scale = 2 * Math.Tan(20 * Math.PI / 180) / Size;
        Vector3 d = Vector3.Normalize(new((float)((x + 0.5 - (Size / 2.0)) * scale), (float)(((Size / 2.0) - y - 0.5) * scale), -1));
        double b = 5 * d.Z, root = (b * b) - 25 + 2.25;
        return root < 0 ? -1 : Math.Sqrt(root) / 1.5;
    }
}
