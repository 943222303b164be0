using OwnMaterial;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>The code of docs/library.md, compiled and run.</summary>
public class LibraryExamples
{
    [Fact]
    public void A_scene_is_built_in_code()
    {
        using TemporaryFolder folder = new();
        string image = folder["sphere.png"];

        // example: code
        Scene scene = Scene.From(new SceneDescription
        {
            Render = new() { Width = 32, Height = 24, Integrator = Integrator.Path },
            Background = "skyblue",
            Shapes = [new SphereDescription { Radius = 1, Material = new DiffuseMaterialDescription { Color = new Rgb(0.8f, 0.2f, 0.1f) } }],
        });
        (Film film, _) = new RTracer(scene).Render();
        ImageFile.Write(image, film);

        // end
        Assert.True(File.Exists(image));
        Assert.True(film[16, 12].R > 2 * film[16, 12].B, "no red sphere in the middle");
    }

    [Fact]
    public void A_scene_is_read_from_a_file()
    {
        string path = ProjectFolder.PathOf("scenes", "primer", "01-sphere.json");

        // example: file
        SceneLoadResult result = SceneLoader.Load(path, s => s with { Render = s.Render with { Width = 32, Height = 24 } });
        foreach (Diagnostic diagnostic in result.Diagnostics)
        {
            Console.Error.WriteLine(diagnostic);
        }

        Scene scene = result.Scene ?? throw new InvalidDataException("the scene has errors");

        // end
        Assert.Equal((32, 24), (scene.Render.Width, scene.Render.Height));
    }

    [Fact]
    public void Progress_is_reported_and_rendering_is_cancelled()
    {
        Scene scene = Scene.From(new() { Render = new() { Width = 32, Height = 24 } });

        // example: progress
        using CancellationTokenSource stop = new(TimeSpan.FromMinutes(10));
        Progress<RenderProgress> progress = new(p => Console.WriteLine($"{p.Fraction:P0}"));
        Film film = new(scene.Render.Width, scene.Render.Height);
        RenderStatistics statistics = new RTracer(scene, new() { Threads = 4 }).Render(film, progress, stop.Token);

        // end
        Assert.NotNull(statistics);
        Assert.Equal(32 * 24 * 16, film.TotalSamples);
    }

    [Fact]
    public void A_film_is_read_as_numbers()
    {
        Scene scene = Scene.From(new() { Render = new() { Width = 32, Height = 24 }, Background = new(0.5f, 0.25f, 1) });
        (Film film, _) = new RTracer(scene).Render();

        // example: numbers
        Rgb pixel = film[10, 20];
        float brightest = film.ToPicture().Pixels.Max();
        string hash = film.ComputeHash();

        // end
        Assert.Equal((new Rgb(0.5f, 0.25f, 1), 1f), (pixel, brightest));
        Assert.NotEmpty(hash);
    }

    [Fact]
    public void What_is_wrong_is_an_exception()
    {
        // example: errors
        SceneDescription wrong = new() { Shapes = [new SphereDescription { Name = "ball", Radius = -1 }] };
        SceneException refusal = Assert.Throws<SceneException>(() => Scene.From(wrong));
        Assert.Equal("SphereDescription \"ball\", Radius: \"radius\" must be greater than 0, but is -1", refusal.Message);

        // end
    }

    [Fact]
    public void A_scene_file_names_a_material_of_the_program()
    {
        // example: plug-in
        Plugins.Add(typeof(Velvet).Assembly);
        SceneLoadResult result = SceneLoader.LoadText("""
            { "background": "white", "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "velvet", "color": "crimson" } }] }
            """, "scene.json", folder: ".");

        // end
        Assert.Empty(result.Diagnostics);
        Assert.IsType<VelvetDescription>(Assert.Single(result.Description!.Shapes).Material);
        Assert.NotNull(result.Scene);
    }

    [Fact]
    public void A_picture_is_compared_with_its_reference()
    {
        using TemporaryFolder folder = new();
        string reference = folder["sphere.pfm"];
        SceneDescription scene = new() { Background = "skyblue", Shapes = [new SphereDescription { Radius = 1 }], Render = new() { Width = 32, Height = 24 } };
        ImageFile.Write(reference, new RTracer(Scene.From(scene)).Render().Film);
        Film film = new RTracer(Scene.From(scene with { Render = scene.Render with { Seed = 1 } })).Render().Film;

        // example: comparison
        ImageComparison comparison = ImageComparison.Compare(film, ImageFile.Read(reference));
        Assert.True(comparison.Rmse < 0.01, $"the picture differs from its reference by {comparison.Rmse}");
        Assert.True(comparison.Ssim > 0.95, $"the picture does not look like its reference: SSIM {comparison.Ssim}");

        // end
        Assert.True(comparison.Rmse > 0);
    }

    [Fact]
    public void The_page_shows_the_material_of_the_sample()
    {
        string material = File.ReadAllText(ProjectFolder.PathOf("samples", "OwnMaterial", "Velvet.cs")).ReplaceLineEndings("\n");
        AssertShown(material.Split("namespace OwnMaterial;\n\n")[1].TrimEnd());
    }

    [Fact]
    public void The_page_shows_a_material_of_the_textbook_edition()
    {
        string material = File.ReadAllText(ProjectFolder.PathOf("tests", "RayTracer.StudentPlugin", "Chalk.cs")).ReplaceLineEndings("\n");
        AssertShown(material.Split("namespace RayTracer.StudentPlugin;\n\n")[1].TrimEnd());
    }

    [Theory]
    [InlineData("code")]
    [InlineData("file")]
    [InlineData("progress")]
    [InlineData("numbers")]
    [InlineData("errors")]
    [InlineData("plug-in")]
    [InlineData("comparison")]
    public void The_page_shows_the_code_that_is_run(string name)
    {
        string code = File.ReadAllText(ProjectFolder.PathOf("tests", "RayTracer.Repository.Tests", "Documentation", "LibraryExamples.cs")).ReplaceLineEndings("\n");
        string example = code.Split($"// example: {name}\n", 2)[1].Split("\n        // end", 2)[0].TrimEnd();
        string shown = string.Join('\n', example.Split('\n').Select(line => line.StartsWith("        ", StringComparison.Ordinal) ? line[8..] : line));
        AssertShown(shown);
    }

    private static void AssertShown(string shown)
    {
        string page = File.ReadAllText(ProjectFolder.PathOf("docs", "library.md")).ReplaceLineEndings("\n");
        Assert.True(page.Contains($"```csharp\n{shown}\n```", StringComparison.Ordinal), $"docs/library.md does not show:\n{shown}");
    }
}
