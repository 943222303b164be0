using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Scenes.Tests;

/// <summary>The scenes of meshes, and models that stand for themselves.</summary>
public class MeshScenesTests
{
    public static TheoryData<string> Files => new(Directory.GetFiles(ProjectFolder.PathOf("scenes", "meshes"), "*.json").Select(f => Path.GetFileName(f)));

    [Theory]
    [MemberData(nameof(Files))]
    public void Mesh_scene_loads_without_diagnostics_and_says_what_it_shows(string file)
    {
        string path = ProjectFolder.PathOf("scenes", "meshes", file);
        SceneLoadResult result = SceneLoader.Load(path);
        Assert.Empty(result.Diagnostics);
        Assert.NotNull(result.Scene);
        Assert.StartsWith("// ", File.ReadAllText(path), StringComparison.Ordinal);
        Assert.Contains("\"$schema\": \"../raytracer.schema.json\"", File.ReadAllText(path), StringComparison.Ordinal);
    }

    [Fact]
    public void What_a_model_file_says_is_said_once_and_about_the_record_that_names_it()
    {
        MeshDescription bad = new() { Data = new([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2, 0, 1, 1]) };
        ImportedModel model = new(new() { Shapes = [bad, new GroupDescription { Shapes = [bad] }] }, ["the animation was left out"]);
        ModelDescription first = new() { File = "a.glb" };
        SceneBuilder builder = new((_, _) => throw new NotSupportedException(), _ => model);
        Assert.NotNull(builder.Build(new() { Shapes = [first, new ModelDescription { File = "a.glb" }] }));
        Assert.Equal(
            ["\"a.glb\": the animation was left out", "the mesh: 1 triangle without area dropped"],
            builder.Complaints.Select(c => c.Message));
        Assert.All(builder.Complaints, c => Assert.True(!c.IsError && ReferenceEquals(c.Subject, first) && c.Property == nameof(ModelDescription.File)));
    }

    [Fact]
    public void A_model_that_cannot_be_read_is_an_error_at_its_file()
    {
        ModelDescription model = new() { File = "a.ply" };
        SceneBuilder builder = new((_, _) => throw new NotSupportedException(), _ => throw new ModelException("line 3: what is this"));
        Assert.Null(builder.Build(new() { Shapes = [model] }));
        Assert.Equal(new SceneComplaint(model, "File", "line 3: what is this", IsError: true), Assert.Single(builder.Complaints));
    }

    [Fact]
    public void A_material_of_the_model_takes_the_place_of_all_of_its_file_and_a_groups_only_of_what_says_nothing()
    {
        LuminaireOrNot lamp = new();
        SphereDescription said = new() { Material = lamp.Lamp };
        ImportedModel model = new(new() { Shapes = [said, new GroupDescription { Shapes = [new SphereDescription()] }] }, []);
        Assert.Equal(1, Lights(new ModelDescription { File = "a" }));
        Assert.Equal(2, Lights(new ModelDescription { File = "a", Material = lamp.Lamp }));
        Assert.Equal(0, Lights(new ModelDescription { File = "a", Material = lamp.Matt }));
        Assert.Equal(2, Lights(new GroupDescription { Shapes = [said, new SphereDescription()], Material = lamp.Lamp }));
        Assert.Equal(1, Lights(new GroupDescription { Shapes = [said, new SphereDescription()], Material = lamp.Matt }));

        int Lights(ShapeDescription shape) =>
            new SceneBuilder((_, _) => throw new NotSupportedException(), _ => model).Build(new() { Shapes = [shape] })!.Lights.Count;
    }

    private sealed class LuminaireOrNot
    {
        public MaterialDescription Lamp { get; } = new RayTracer.Materials.LuminaireMaterialDescription();

        public MaterialDescription Matt { get; } = new RayTracer.Materials.DiffuseMaterialDescription();
    }
}
