using System.Numerics;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

public class MitsubaSensorTests
{
    private const string Film = """<film type="hdrfilm"><integer name="width" value="30"/><integer name="height" value="20"/><rfilter type="box"/></film>""";

    [Fact]
    public void A_sensor_without_an_angle_has_a_lens_of_50_millimetres()
    {
        CameraDescription standard = TestScene.Of("", $"""<sensor type="perspective">{Film}</sensor>""").Camera;
        Assert.Equal(TestScene.Of("", $"""<sensor type="perspective"><string name="focal_length" value="50mm"/>{Film}</sensor>""").Camera, standard);
        Assert.Equal((FieldOfViewAxis.Diagonal, 46.793f), (standard.FieldOfViewAxis, float.Round(standard.FieldOfView, 3)));
    }

    [Theory]
    [InlineData("moment")]
    [InlineData("aov")]
    public void Of_an_integrator_that_writes_further_images_the_inner_one_counts(string type)
    {
        using TestScene scene = new();
        SceneReadResult read = MitsubaReader.Read(scene.Write("scene.xml", $"""<integrator type="{type}"><integrator type="path"><integer name="max_depth" value="3"/></integrator></integrator>"""));
        Assert.Equal(Severity.Warning, Assert.Single(read.Diagnostics).Severity);
        Assert.Equal((Integrator.Path, 3), (read.Description!.Render.Integrator, read.Description.Render.MaxDepth));
    }

    [Fact]
    public void Cameras_look_along_z_of_their_frame_and_measure_the_width()
    {
        CameraDescription camera = TestScene.Of("", $"""
            <sensor type="thinlens">
              <transform name="to_world"><lookat origin="1, 2, 3" target="1, 2, -7" up="0, 2, 0"/></transform>
              <float name="fov" value="50"/><float name="aperture_radius" value="0.1"/><float name="focus_distance" value="4"/>{Film}
            </sensor>
            """).Camera;
        Assert.Equal((new(1, 2, 3), new(1, 2, 2), Vector3.UnitY), (camera.Position, camera.LookAt, camera.Up));
        Assert.Equal((50, FieldOfViewAxis.Horizontal), (camera.FieldOfView, camera.FieldOfViewAxis));
        Assert.Equal((0.1f, 4), (camera.Lens.ApertureRadius, camera.Lens.FocusDistance));
    }

    [Theory]
    [InlineData("x", FieldOfViewAxis.Horizontal)]
    [InlineData("y", FieldOfViewAxis.Vertical)]
    [InlineData("diagonal", FieldOfViewAxis.Diagonal)]
    [InlineData("smaller", FieldOfViewAxis.Smaller)]
    [InlineData("larger", FieldOfViewAxis.Larger)]
    public void Axes_of_the_field_of_view_are_known(string word, FieldOfViewAxis axis) =>
        Assert.Equal(axis, TestScene.Of("", $"""<sensor type="perspective"><float name="fov" value="50"/><string name="fov_axis" value="{word}"/>{Film}</sensor>""").Camera.FieldOfViewAxis);

    [Fact]
    public void A_camera_without_an_aperture_may_say_what_is_sharp() => Assert.Equal(
        50, TestScene.Of("", $"""<sensor type="perspective"><float name="focus_distance" value="1000"/><float name="fov" value="50"/>{Film}</sensor>""").Camera.FieldOfView);

    [Fact]
    public void Focal_lengths_are_of_35_mm_film()
    {
        CameraDescription camera = TestScene.Of("", $"""<sensor type="perspective"><string name="focal_length" value="50mm"/>{Film}</sensor>""").Camera;
        Assert.Equal(FieldOfViewAxis.Diagonal, camera.FieldOfViewAxis);
        Assert.Equal(46.79, camera.FieldOfView, 0.01);
    }

    [Theory]
    [InlineData("independent", 10, "independent", 10)]
    [InlineData("stratified", 16, "jittered", 16)]
    public void Samplers_are_those_that_are_nearest(string type, int count, string kind, int samples)
    {
        RenderDescription render = TestScene.Of("", $"""
            <sensor type="perspective"><float name="fov" value="50"/>{Film}
              <sampler type="{type}"><integer name="sample_count" value="{count}"/><integer name="seed" value="7"/></sampler>
            </sensor>
            """).Render;
        Assert.Equal((kind, samples, 7), (render.Sampler.Name, render.SamplesPerPixel, render.Seed));
    }

    [Fact]
    public void A_film_without_a_filter_has_a_gaussian_that_ends_after_two_pixels()
    {
        RenderDescription render = TestScene.Of("", """<sensor type="perspective"><float name="fov" value="50"/></sensor>""").Render;
        Assert.Equal((768, 576), (render.Width, render.Height));
        Assert.Equal(new FilterDescription { Shape = FilterShape.Gaussian, Deviation = 0.5f, Radius = 2 }, render.Filter);
    }

    // A crop of 20×10 at (4, 6) of 30×20 pixels.
    [Theory]
    [InlineData("perspective", "<float name=\"fov\" value=\"50\"/>")]
    [InlineData("orthographic", "<transform name=\"to_world\"><scale value=\"2\"/></transform>")]
    public void A_crop_shows_that_part_of_the_whole_picture(string type, string properties)
    {
        string Sensor(string crop) => $"""<sensor type="{type}">{properties}<film type="hdrfilm"><integer name="width" value="30"/><integer name="height" value="20"/>{crop}<rfilter type="box"/></film></sensor>""";
        Film whole = Render(Sensor(""));
        Film part = Render(Sensor("""<integer name="crop_offset_x" value="4"/><integer name="crop_offset_y" value="6"/><integer name="crop_width" value="20"/><integer name="crop_height" value="10"/>"""));
        Assert.Equal((20, 10), (part.Width, part.Height));
        float[] expected = new float[90];
        float[] found = new float[60];
        for (int y = 0; y < 10; y++)
        {
            whole.ReadRow(y + 6, expected);
            part.ReadRow(y, found);
            Assert.All(found.Zip(expected.AsSpan(12, 60).ToArray()), p => Assert.Equal(p.Second, p.First, 0.03));
        }

        static Film Render(string sensor)
        {
            using TestScene scene = new();
            string path = scene.Write("scene.xml", """<shape type="sphere"><point name="center" z="5"/><float name="radius" value="2"/></shape>""", sensor);
            return new RTracer(SceneRuns.Load(path, d => d with { Render = d.Render with { Integrator = Integrator.Normals, SamplesPerPixel = 64 } })).Render().Film;
        }
    }

    [Theory]
    [InlineData("<integrator type=\"path\"/>", -1)]
    [InlineData("<integrator type=\"path\"><integer name=\"max_depth\" value=\"5\"/></integrator>", 5)]
    [InlineData("<integrator type=\"direct\"/>", 2)]
    public void Integrators_count_the_edges_of_paths(string integrator, int depth)
    {
        RenderDescription render = TestScene.Of(integrator).Render;
        Assert.Equal((Integrator.Path, depth), (render.Integrator, render.MaxDepth));
    }

    [Fact]
    public void Auxiliary_integrators_and_other_noise_are_warnings()
    {
        Assert.Contains("--aov", TestScene.Complaint("""<integrator type="aov"><string name="aovs" value="dd:depth"/><integrator type="path"/></integrator>"""), StringComparison.Ordinal);
        Assert.StartsWith("the sampler \"sobol\"", TestScene.Complaint("", $"""<sensor type="perspective"><float name="fov" value="50"/>{Film}<sampler type="multijitter"/></sensor>"""), StringComparison.Ordinal);
    }

    // Mitsuba 3.9.1 shows what lies on the axis at 0.3 of the width and 0.4 of the height, from the upper left.
    [Fact]
    public void A_principal_point_moves_what_lies_on_the_axis_the_other_way()
    {
        CameraDescription camera = TestScene.Of("", """
            <sensor type="perspective"><float name="fov" value="40"/><float name="principal_point_offset_x" value="0.2"/><float name="principal_point_offset_y" value="0.1"/>
            <film type="hdrfilm"><integer name="width" value="64"/><integer name="height" value="32"/><rfilter type="box"/></film></sensor>
            """).Camera;
        Assert.Equal(0.3f, (0.5f - camera.Window[0]) / camera.Window[2], 1e-5f);
        Assert.Equal(0.4f, (0.5f - camera.Window[1]) / camera.Window[3], 1e-5f);
        Assert.Equal(Math.Tan(20 * Math.PI / 180) / camera.Window[2], Math.Tan(camera.FieldOfView * Math.PI / 360), 1e-5);
    }

    [Theory]
    [InlineData("near_clip", "0.5")]
    [InlineData("far_clip", "20")]
    public void Planes_that_would_cut_are_warned_of(string name, string value) => Assert.Equal(
        $"\"{name}\" does not clip here: everything in front of the camera is visible",
        TestScene.Complaint("", TestScene.Sensor.Replace("<film", $"<float name=\"{name}\" value=\"{value}\"/><film", StringComparison.Ordinal)));
}
