using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Cli.Tests;

/// <summary><c>raytracer explain</c>.</summary>
public class ExplainTests
{
    [Theory]
    [InlineData("camera.fieldOfView", "camera.fieldOfView\n  Only for perspective: the full angle", "unit     degrees\n", "range    from 0.001 to 179\n", "default  40\n")]
    [InlineData("render.sampler", "value    \"sobol\", \"jittered\", \"regular\", \"independent\"\n", "default  \"sobol\"\n")]
    [InlineData("camera.lens.blades", "value    whole number\n")]
    [InlineData("materials.window.refractiveIndex", "dielectric.refractiveIndex", "range    ")]
    [InlineData("materials.glass", "dielectric.glass", "\"bk7\"")]
    [InlineData("materials.mine", "  One of these types:\n", "  diffuse ")]
    [InlineData("materials.difuse", "  A name of a scene's own (did you mean \"diffuse\"?). One of these types:\n")]
    [InlineData("shapes[2].radius", "sphere.radius", "range    greater than 0\n")]
    [InlineData("shapes.globe.material.color", "diffuse.color")]
    [InlineData("sphere", "sphere (shape)\n  A sphere.", "  radius ")]
    [InlineData("image", "image (texture)\n", "image (environment)\n")]
    [InlineData("material", "material\n  One of these types:\n", "  dielectric ")]
    [InlineData("radius", "cylinder.radius, disk.radius, sphere.radius\n")]
    public void What_can_stand_in_a_scene_is_explained(string topic, params string[] parts)
    {
        CliRun run = CliRun.Of("explain", topic);
        Assert.Equal((0, ""), (run.Status, run.Error));
        Assert.All(parts, part => Assert.Contains(part, run.Output, StringComparison.Ordinal));
        Assert.DoesNotContain("](#", run.Output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("camera.fov", "there is no \"fov\" in \"camera\" (did you mean \"fieldOfView\"?)")]
    [InlineData("camera.xyzzy", "there is no \"xyzzy\" in \"camera\": there are ")]
    [InlineData("spher", "nothing is called \"spher\" (did you mean \"sphere\"?)")]
    [InlineData("camera.fieldOfView.x", "\"camera.fieldOfView\" has no parts")]
    [InlineData("", "TOPIC: the word is empty")]
    public void A_miss_has_the_nearest_right_word(string topic, string message)
    {
        CliRun run = CliRun.Of("explain", topic);
        Assert.Equal((2, ""), (run.Status, run.Output));
        Assert.StartsWith($"raytracer: error: {message}", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Every_parameter_is_found_under_its_type()
    {
        foreach (RecordType type in SceneTypes.Families.SelectMany(f => f.Types).Concat(SceneTypes.Parts).Where(t => t != SceneTypes.Scene))
        {
            foreach (RecordParameter parameter in type.Parameters)
            {
                Assert.Contains(parameter.Summary.Split(['[', '`'])[0], SceneExplanation.Of($"{type.Name}.{parameter.Key}"), StringComparison.Ordinal);
            }
        }
    }

    [Fact]
    public void Without_a_topic_all_are_listed()
    {
        string topics = CliRun.Of("explain").Output;
        Assert.All(SceneTypes.Families.SelectMany(f => f.Names).Concat(SceneTypes.Scene.Parameters.Select(p => p.Key)), name => Assert.Contains(name, topics, StringComparison.Ordinal));
    }
}
