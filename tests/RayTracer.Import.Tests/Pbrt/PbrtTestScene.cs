using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

/// <summary>Scenes in pbrt's format, in files of a folder that is removed with them.</summary>
internal sealed class PbrtTestScene : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public string this[string name] => _folder[name];

    /// <summary>Reads a scene of some things.</summary>
    public static SceneDescription Of(string things, string before = "")
    {
        using PbrtTestScene scene = new();
        SceneReadResult read = PbrtReader.Read(scene.Write("scene.pbrt", things, before));
        Assert.Equal("", Diagnostic.Format([.. read.Diagnostics]));
        return read.Description!;
    }

    /// <summary>The medium in the first shape of a scene of some things.</summary>
    public static MediumDescription Filled(string things) => ((InvisibleMaterialDescription)Of(things).Shapes[0].Material).Interior;

    /// <summary>The only diagnostic of a scene of some things.</summary>
    public static string Complaint(string things, string before = "")
    {
        using PbrtTestScene scene = new();
        return Assert.Single(PbrtReader.Read(scene.Write("scene.pbrt", things, before)).Diagnostics).Message;
    }

    /// <summary>The picture of a scene.</summary>
    public static Film Render(string things, string before)
    {
        using PbrtTestScene scene = new();
        SceneLoadResult load = SceneLoader.Load(scene.Write("scene.pbrt", things, before));
        Assert.Equal("", Diagnostic.Format([.. load.Diagnostics.Where(d => d.Severity == Severity.Error)]));
        return new RTracer(load.Scene!).Render().Film;
    }

    public string Write(string name, string things, string before = "")
    {
        File.WriteAllText(this[name], $"{before}\nWorldBegin\n{things}\n");
        return this[name];
    }

    public void Dispose() => _folder.Dispose();
}
