using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Materials;
using RayTracer.Rendering;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace PictureTests;

/// <summary>A rendered picture, compared with one that was looked at and committed.</summary>
public class SphereTests
{
    private static readonly string s_reference = Path.Combine(AppContext.BaseDirectory, "sphere.pfm");

    [Fact]
    public void The_sphere_has_the_bits_of_its_reference()
    {
        Picture picture = Render(seed: 0);
        if (Environment.GetEnvironmentVariable("UPDATE_REFERENCE") is { Length: > 0 } path)
        {
            ImageFile.Write(path, picture);
        }

        Assert.Equal(0, ImageComparison.Compare(picture, ImageFile.Read(s_reference)).LargestDifference);
    }

    [Fact]
    public void With_other_random_numbers_it_looks_the_same()
    {
        ImageComparison comparison = ImageComparison.Compare(Render(seed: 1), ImageFile.Read(s_reference));
        Assert.InRange(comparison.Rmse, 1e-6, 0.01);
        Assert.InRange(comparison.Ssim, 0.98, 1);
    }

    [Fact]
    public void A_sphere_of_another_colour_is_noticed() =>
        Assert.InRange(ImageComparison.Compare(Render(seed: 0, color: "orange"), ImageFile.Read(s_reference)).Rmse, 0.03, 1);

    private static Picture Render(long seed, string color = "tomato")
    {
        Scene scene = Scene.From(new SceneDescription
        {
            Render = new() { Width = 48, Height = 36, SamplesPerPixel = 64, Integrator = Integrator.Path, Seed = seed },
            Background = "skyblue",
            Shapes = [new SphereDescription { Radius = 1, Material = new DiffuseMaterialDescription { Color = color } }],
        });
        return new RTracer(scene).Render().Film.ToPicture();
    }
}
