using RayTracer.Imaging;
using RayTracer.Tests.Imaging;
using RayTracer.Textures;

namespace RayTracer.Tests.Cli;

public class ConvertTests
{
    private const string Xml = """
        <scene version="3.0.0">
          <sensor type="perspective"><float name="fov" value="40"/><film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="6"/></film></sensor>
          <shape type="cube"><transform name="to_world"><translate z="5"/></transform>
            <bsdf type="diffuse"><texture type="bitmap" name="reflectance"><string name="filename" value="p.png"/></texture></bsdf>
          </shape>
          <emitter type="constant"/>
        </scene>
        """;

    [Fact]
    public void A_converted_scene_makes_the_same_film_from_another_folder()
    {
        using TemporaryFolder folder = new();
        Write(folder);
        Directory.CreateDirectory(folder["out"]);
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of("convert", folder["scene.xml"], folder["out/scene.json"]));
        Assert.Contains("\"../p.png\"", File.ReadAllText(folder["out/scene.json"]), StringComparison.Ordinal);
        Assert.Equal(Pixel(folder["scene.xml"]), Pixel(folder["out/scene.json"]));
    }

    [Fact]
    public void Nothing_is_written_where_there_is_an_error()
    {
        using TemporaryFolder folder = new();
        Write(folder);
        File.Delete(folder["p.png"]);
        Assert.Equal(3, CliRun.Of("convert", folder["scene.xml"], folder["scene.json"]).Status);
        Assert.Equal(4, CliRun.Of("convert", folder["missing.xml"], folder["scene.json"]).Status);
        Assert.Equal(2, CliRun.Of("convert", folder["scene.xml"], folder["scene.txt"]).Status);
        Assert.False(File.Exists(folder["scene.json"]));
    }

    private static void Write(TemporaryFolder folder)
    {
        File.WriteAllText(folder["scene.xml"], Xml);
        ImageFile.Write(folder["p.png"], new Picture(2, 1, [1, 0.5f, 0.25f, 0, 0, 1]));
    }

    private static string Pixel(string scene)
    {
        CliRun run = CliRun.Of("render", scene, "--pixel", "4,3");
        Assert.Equal(0, run.Status);
        return string.Concat(run.Output.Split('\n').Where(l => !l.Contains(scene, StringComparison.Ordinal)));
    }
}
