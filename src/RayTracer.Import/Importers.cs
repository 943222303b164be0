using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>The formats of models and scenes that this assembly reads.</summary>
public static class Importers
{
    /// <summary>Makes them known to <see cref="ModelFile"/> and <see cref="SceneLoader"/>; programs call it once, at their start.</summary>
    public static void Register()
    {
        ModelFile.Register(".glb", GltfReader.Read);
        ModelFile.Register(".gltf", GltfReader.Read);
        ModelFile.Register(".obj", ObjReader.Read);
        ModelFile.Register(".ply", PlyReader.Read);
        ModelFile.Register(".serialized", SerializedReader.Read);
        ModelFile.Register(".stl", StlReader.Read);
        SceneFormat.Register(new(".xml", MitsubaReader.Read));
        SceneFormat.Register(new(".pbrt", PbrtReader.Read));
        SceneFormat.Register(new(".pbrt.gz", PbrtReader.Read));
    }
}
