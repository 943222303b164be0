using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

/// <summary>Scenes in Mitsuba's format, in files of a folder that is removed with them.</summary>
internal sealed class TestScene : IDisposable
{
    public const string Sensor = """<sensor type="perspective"><float name="fov" value="40"/><film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/><rfilter type="box"/></film></sensor>""";

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("raytracer-mitsuba-");

    public string this[string name] => Path.Combine(_folder.FullName, name);

    /// <summary>Reads a scene of some things.</summary>
    public static SceneDescription Of(string things, string sensor = Sensor)
    {
        using TestScene scene = new();
        SceneReadResult read = MitsubaReader.Read(scene.Write("scene.xml", things, sensor));
        Assert.Equal("", Diagnostic.Format([.. read.Diagnostics]));
        return read.Description!;
    }

    /// <summary>The only diagnostic of a scene of some things.</summary>
    public static string Complaint(string things, string sensor = Sensor)
    {
        using TestScene scene = new();
        return Assert.Single(MitsubaReader.Read(scene.Write("scene.xml", things, sensor)).Diagnostics).Message;
    }

    public string Write(string name, string things, string sensor = Sensor)
    {
        File.WriteAllText(this[name], $"<scene version=\"3.0.0\">\n{sensor}\n{things}\n</scene>\n");
        return this[name];
    }

    public void Dispose() => _folder.Delete(recursive: true);
}
