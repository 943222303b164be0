using System.Numerics;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>What curves of straight pieces become.</summary>
[Trait("Category", "Thorough")]
public class MitsubaCurveTests
{
    // A ball at each point, whose radius no scale changes, and between two of them the cone that touches both: at the points where it does, its slant is at right angles to their radii.
    [Fact]
    public void Curves_are_balls_and_the_cones_that_touch_them()
    {
        using TestScene folder = new();
        File.WriteAllText(folder["curves.txt"], "0 0 0 2\n 0\t0 2 1 \r\n\n\n1 0 0 0.5\n1 0 0.1 0.25\n4 0 0.1 0\n");
        SceneReadResult read = MitsubaReader.Read(folder.Write("scene.xml", """
            <shape type="linearcurve"><string name="filename" value="curves.txt"/><transform name="to_world"><scale x="1" y="1" z="2"/></transform></shape>
            """));
        Assert.Equal("", Diagnostic.Format([.. read.Diagnostics]));
        IReadOnlyList<ShapeDescription> parts = Assert.IsType<GroupDescription>(Assert.Single(read.Description!.Shapes)).Shapes;
        SphereDescription[] balls = [.. parts.OfType<SphereDescription>()];
        Assert.Equal([(new(0, 0, 0), 2f), (new(0, 0, 4), 1f), (new(1, 0, 0), 0.5f), (new(1, 0, 0.2f), 0.25f)], balls.Select(b => (b.Center, b.Radius)));

        // The second ball of the second curve is within the first, and its end is a point.
        ConeDescription[] cones = [.. parts.OfType<ConeDescription>()];
        Assert.Equal(2, cones.Length);
        Assert.Equal(0, cones[1].TopRadius);
        Assert.Equal(new(4, 0, 0.2f), cones[1].Top);
        Assert.False(cones[0].Caps);
        Vector3 bottom = cones[0].Bottom + new Vector3(cones[0].Radius, 0, 0);
        Vector3 top = cones[0].Top + new Vector3(cones[0].TopRadius, 0, 0);
        foreach ((Vector3 touched, SphereDescription ball) in new[] { (bottom, balls[0]), (top, balls[1]) })
        {
            Assert.Equal(ball.Radius, (touched - ball.Center).Length(), 1e-5);
            Assert.Equal(0, Vector3.Dot(touched - ball.Center, top - bottom), 1e-5);
        }
    }

    // Files come from anywhere: whatever they hold, they are read or refused.
    [Fact]
    public void Damaged_curves_are_read_or_refused()
    {
        using TestScene folder = new();
        Random random = new(21 + TestSettings.Seed);
        int rounds = TestSettings.Scale(200, 5000);
        int refused = 0;
        string[] pieces = ["\n", "\n\n", " ", "1e38 ", "-1 ", "nan ", "0 ", "\0", "9999999999999999999999", "\uFFFD", ""];
        string scene = folder.Write("scene.xml", """<shape type="linearcurve"><string name="filename" value="curves.txt"/></shape>""");
        for (int round = 0; round < rounds; round++)
        {
            string text = "0 0 0 2\n0 0 2 1\n\n1 0 0 0.5\n1 0 0.1 0.25\n4 0 0.1 0\n";
            for (int damage = random.Next(1, 4); damage > 0; damage--)
            {
                int at = random.Next(text.Length);
                text = text.Remove(at, int.Min(random.Next(3), text.Length - at)).Insert(at, pieces[random.Next(pieces.Length)]);
            }

            File.WriteAllText(folder["curves.txt"], text);
            SceneLoadResult load = SceneLoader.Load(scene);
            refused += load.Scene is null ? 1 : 0;
            Assert.Equal(load.Diagnostics.Any(d => d.Severity == Severity.Error), load.Scene is null);
        }

        Assert.InRange(refused, rounds / 5, rounds - (rounds / 20));
    }
}
