using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

/// <summary>Outputs that would replace what is read, by whatever name they are called, and checkpoints that would replace other films.</summary>
public sealed class LostFileTests : IDisposable
{
    private const string Refusal = "this file is read, and would be lost: give another name";
    private const int Failed = 4;
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;
    private readonly string _texture;

    public LostFileTests()
    {
        (_scene, _texture) = (_folder["scene.json"], _folder["tex.png"]);
        string image = """{ "type": "image", "file": "tex.png" }""";
        File.WriteAllText(_scene, "// A comment.\n" + CliRun.Scene.Replace("""{ "type": "checker" }""", image, StringComparison.Ordinal));
        ImageFile.Write(_texture, TestPictures.Noise(4, 4));
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void A_picture_of_the_scene_is_not_replaced_by_its_rendering()
    {
        Keeps(_texture, "render", _scene, "-o", _folder["good.png"], "-o", _texture);
        Assert.False(File.Exists(_folder["good.png"]));
        Keeps(_texture, "render", _scene, "-o", _folder["./x/../tex.png"]);
        Keeps(_texture, "sweep", _scene, "--set", "render.seed=1,2", "-o", _texture);
        Keeps(_texture, "cluster", "slurm", _scene, "--tasks", "2", "-o", _texture);
        Keeps(_texture, "render", _scene, "-o", _texture, "--checkpoint", _folder["c.rtfilm"]);
    }

    [LinuxFact]
    public void Links_of_an_input_are_known()
    {
        string hard = _folder["hard.png"];
        string soft = _folder["soft.png"];
        System.Diagnostics.Process.Start("ln", [_texture, hard]).WaitForExit();
        File.CreateSymbolicLink(soft, _texture);
        Keeps(hard, "render", _scene, "-o", hard);
        Keeps(_texture, "render", _scene, "-o", soft);
        Assert.Equal(_texture, new FileInfo(soft).LinkTarget);
    }

    [Fact]
    public void Images_beside_an_output_replace_no_input_either()
    {
        File.Move(_texture, _folder["out.depth.png"]);
        File.WriteAllText(_scene, File.ReadAllText(_scene).Replace("tex.png", "out.depth.png", StringComparison.Ordinal));
        Keeps(_folder["out.depth.png"], "render", _scene, "-o", _folder["out.png"], "--aov", "depth");
    }

    [Fact]
    public void A_scene_keeps_its_comments_when_it_is_converted_to_itself()
    {
        Keeps(_scene, "convert", _scene, _scene);
        Keeps(_scene, "convert", _scene, "-o", _folder["./scene.json"]);
    }

    [Fact]
    public void A_model_with_its_materials_is_kept()
    {
        string model = _folder["m.obj"];
        string materials = _folder["m.png"];
        File.WriteAllText(materials, "newmtl red\nKd 1 0 0\n");
        File.WriteAllText(model, "mtllib m.png\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Keeps(materials, "render", model, "-o", materials, "--spp", "1", "--width", "8");
    }

    [Fact]
    public void Images_and_films_that_are_read_are_kept()
    {
        string layers = _folder["l.exr"];
        string film = _folder["f.rtfilm"];
        string other = _folder["g.rtfilm"];
        CliRun.Fine("render", _scene, "-o", layers, "--aov", "lights", "--integrator", "path", "--quiet");
        CliRun.Fine("render", _scene, "-o", film, "--part", "1/2", "--quiet");
        CliRun.Fine("render", _scene, "-o", other, "--part", "2/2", "--quiet");
        Keeps(layers, "compose", layers, "--others", "2", "-o", layers);
        Keeps(layers, "convert", layers, layers);
        Keeps(layers, "denoise", layers, "-o", layers);
        Keeps(_texture, "denoise", layers, "--albedo", layers, "-o", _folder["fine.png"], "-o", layers);
        Keeps(layers, "compare", layers, layers, "-o", layers);
        Keeps(film, "merge", film, other, "-o", film);
        Keeps(film, "convert", film, film);
    }

    [Fact]
    public void What_was_read_by_one_command_may_be_written_by_the_next()
    {
        CliRun.Fine("compare", _texture, _texture);
        CliRun.Fine("render", _folder["../" + Path.GetFileName(_folder.Path) + "/scene.json"], "-o", _folder["a.png"], "--quiet");
        CliRun.Fine("compare", _folder["a.png"], _folder["a.png"]);
        CliRun.Fine("render", _scene, "-o", _folder["a.png"], "--quiet");
    }

    [Fact]
    public void Frames_that_are_there_but_of_other_samples_are_replaced()
    {
        string[] frames = ["render", _scene, "--frames", "0..1", "-o", _folder["f-#.png"], "--quiet"];
        CliRun.Fine(frames);
        byte[] first = File.ReadAllBytes(_folder["f-0.png"]);
        CliRun.Fine([.. frames, "--spp", "2"]);
        Assert.NotEqual(first, File.ReadAllBytes(_folder["f-0.png"]));
    }

    [Fact]
    public void A_checkpoint_replaces_no_film_of_another_picture()
    {
        string film = _folder["c.rtfilm"];
        CliRun.Fine("render", _scene, "--checkpoint", film, "--quiet");
        string[] other = ["render", _scene, "--checkpoint", film, "--seed", "2"];
        Keeps(film, "holds samples 0..3 of another picture: give another name, or delete it", other);
        Keeps(film, "of another picture", [.. other, "--overwrite"]);
        Keeps(film, "of another picture", [.. other, "--noise", "50%"]);
    }

    [Fact]
    public void A_checkpoint_replaces_nothing_that_is_no_film_or_a_damaged_one()
    {
        string film = _folder["c.rtfilm"];
        File.WriteAllText(film, "notes");
        Keeps(film, "holds no film that can be read", ["render", _scene, "--checkpoint", film, "--overwrite"]);
        File.WriteAllText(film, "");
        CliRun.Fine("render", _scene, "--checkpoint", film, "--quiet");
    }

    [Fact]
    public void A_checkpoint_of_the_same_picture_is_replaced_where_that_is_said()
    {
        string film = _folder["c.rtfilm"];
        string[] command = ["render", _scene, "--checkpoint", film, "--quiet"];
        CliRun.Fine(command);
        Keeps(film, "holds samples 0..3 of this picture: --resume continues it, --overwrite begins from scratch", [.. command, "--spp", "2"]);
        CliRun.Fine([.. command, "--spp", "2", "--overwrite"]);
        Assert.Equal("0..1", FilmFile.ReadHeader(film).SamplesText);
        CliRun.Fine([.. command, "--resume"]);
        Assert.Equal("0..3", FilmFile.ReadHeader(film).SamplesText);
    }

    [Fact]
    public void A_film_that_is_resumed_into_another_checkpoint_replaces_none_there()
    {
        (string film, string there) = (_folder["c.rtfilm"], _folder["d.rtfilm"]);
        CliRun.Fine("render", _scene, "--checkpoint", film, "--quiet");
        CliRun.Fine("render", _scene, "--checkpoint", there, "--quiet", "--spp", "9");
        Keeps(there, "give another name, or delete it", ["resume", film, "--spp", "8", "--checkpoint", there]);
        CliRun.Fine("resume", film, "--spp", "8", "--quiet");
    }

    private static void Keeps(string file, params string[] args) => Keeps(file, Refusal, args);

    private static void Keeps(string file, string message, string[] args)
    {
        byte[] before = File.ReadAllBytes(file);
        CliRun.Refused(Failed, message, args);
        Assert.Equal(before, File.ReadAllBytes(file));
    }
}
