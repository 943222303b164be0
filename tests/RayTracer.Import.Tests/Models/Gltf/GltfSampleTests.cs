using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>Public files, where they are there.</summary>
public class GltfSampleTests
{
    [SkippableTheory]
    [InlineData("2CylinderEngine-glTF-Binary/2CylinderEngine.glb", 121_496)]
    [InlineData("BoxTextured-glTF/BoxTextured.gltf", 12)]
    [InlineData("BoxTextured-glTF-Binary/BoxTextured.glb", 12)]
    [InlineData("BoxTextured-glTF-Embedded/BoxTextured.gltf", 12)]
    [InlineData("BoxTexcoords-glTF/boxTexcoords.gltf", 12)]
    [InlineData("BoxBadNormals-glTF-Binary/BoxBadNormals.glb", 12)]
    [InlineData("ClearCoat-glTF/ClearCoatTest.gltf", 37_116)]
    [InlineData("cameras/Cameras.gltf", 2)]
    [InlineData("textureTransform/TextureTransformTest.gltf", 24)]
    [InlineData("glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_00.gltf", 0)]
    [InlineData("glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_04.gltf", 2)]
    [InlineData("glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_07.gltf", 0)]
    [InlineData("glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_15.gltf", 2)]
    public void Samples_are_read(string path, int triangles)
    {
        ImportedModel model = GltfReader.Read(Sample(path));
        Assert.Equal(triangles, model.Scene.Shapes.Sum(Triangles));
    }

    [SkippableTheory]
    [InlineData("IndexOutOfRange/IndexOutOfRange.gltf", "vertices")]
    [InlineData("IndexOutOfRange/AllIndicesOutOfRange.gltf", "vertices")]
    [InlineData("MissingBin/BoxTextured.gltf", "buffers[0].uri: cannot read")]
    [InlineData("RecursiveNodes/RecursiveNodes.gltf", "reached twice")]
    public void Samples_that_are_broken_on_purpose_are_refused(string path, string expected) =>
        Assert.Contains(expected, Assert.Throws<ModelException>(() => GltfReader.Read(Sample(path))).Message, StringComparison.Ordinal);

    private static string Sample(string path)
    {
        string? file = ProjectFolder.Shared(["data", "gltf", .. path.Split('/')]);
        Skip.If(file is null, "the public models are not here: ../shared/data/gltf");
        return file!;
    }

    private static int Triangles(ShapeDescription shape) => shape switch
    {
        MeshDescription mesh => mesh.Data!.TriangleCount,
        GroupDescription group => group.Shapes.Sum(Triangles),
        InstanceDescription instance => Triangles(instance.Of!),
        _ => 0,
    };
}
