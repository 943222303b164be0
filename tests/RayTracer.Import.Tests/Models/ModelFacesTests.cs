using System.Text;
using RayTracer.Description;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>Polygons of files are known by their triangles, so that subdivision takes them as they are.</summary>
public class ModelFacesTests
{
    [Fact]
    public void Triangles_of_a_PLY_files_polygons_are_numbered_by_the_first()
    {
        const string header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n";
        const string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n";
        Assert.Equal([0, 1, 1, 3, 3, 3], PlyReader.Parse(Encoding.ASCII.GetBytes($"{header}{points}3 0 1 2\n4 0 1 2 3\n5 0 1 4 2 3\n"), []).FaceOfTriangle!);
        Assert.Null(PlyReader.Parse(Encoding.ASCII.GetBytes($"{header}{points}3 0 1 2\n3 0 2 3\n3 1 4 2\n"), []).FaceOfTriangle);
    }

    [Fact]
    public void So_are_those_of_an_OBJ_file_in_each_of_its_meshes()
    {
        using TestScene folder = new();
        File.WriteAllText(folder["two.obj"], "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0\ng one\nf 1 2 3 4\nf 2 5 3\ng two\nf 1 2 3\nf 1 3 4\ng one\nf 1 2 5 3 4\n");
        int[]?[] faces = [.. ObjReader.Read(folder["two.obj"]).Scene.Shapes.Select(s => ((MeshDescription)s).Data!.FaceOfTriangle)];
        Assert.Equal([0, 0, 2, 5, 5, 5], faces[0]!);
        Assert.Null(faces[1]);
    }
}
