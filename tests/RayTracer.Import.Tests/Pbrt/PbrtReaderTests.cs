using System.IO.Compression;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Spectra;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

public sealed class PbrtReaderTests : IDisposable
{
    public void Dispose() => ImportSettings.IsLenient = false;

    [Fact]
    public void Spaces_of_pbrt_are_left_handed_unless_they_are_mirrored()
    {
        const string ball = """AttributeBegin AreaLightSource "diffuse" Translate 1 0 0 Shape "sphere" "float radius" 0.5 AttributeEnd""";
        const string film = """Film "rgb" "integer xresolution" 2 "integer yresolution" 1 PixelFilter "box" Sampler "zsobol" "integer pixelsamples" 64 """;
        const string camera = """LookAt 0 0 -4 0 0 0 0 1 0 Camera "perspective" "float fov" 60 """;
        Film plain = PbrtTestScene.Render(ball, film + camera);
        Film mirrored = PbrtTestScene.Render(ball, film + "Scale -1 1 1 " + camera);
        Assert.True(plain.Mean(1, 0).G > 0.01 && plain.Mean(0, 0).G == 0);
        Assert.True(mirrored.Mean(0, 0).G > 0.01 && mirrored.Mean(1, 0).G == 0);
    }

    [Fact]
    public void Transforms_are_applied_from_the_last_to_the_first()
    {
        SceneDescription scene = PbrtTestScene.Of("""
            Translate 1 2 3
            AttributeBegin Rotate 90 0 0 1 Scale 2 2 2 CoordinateSystem "here" Shape "sphere" AttributeEnd
            Shape "sphere" "float radius" 3
            TransformBegin CoordSysTransform "here" ConcatTransform [1 0 0 0  0 1 0 0  0 0 1 0  5 0 0 1] Shape "sphere" TransformEnd
            Transform [1 0 0 0  0 1 0 0  0 0 1 0  7 8 9 1] Shape "sphere"
            """);
        Assert.Equal([(new(1, 2, 3), 2f), (new(1, 2, 3), 3f), (new(1, 12, 3), 2f), (new(7, 8, 9), 1f)], scene.Shapes.Cast<SphereDescription>().Select(s => (Rounded(s.Center), MathF.Round(s.Radius, 4))));
    }

    [Fact]
    public void Patches_have_the_uv_of_their_corners()
    {
        const string square = """Shape "bilinearmesh" "point3 P" [0 0 0  2 0 0  0 2 0  2 2 0] """;
        MeshDescription Patch(string more) => (MeshDescription)PbrtTestScene.Of(square + more).Shapes[0];
        Vector2 At(MeshDescription mesh, Vector3 point) => mesh.Uv[mesh.Positions.ToList().FindIndex(p => (p - point).Length() < 1e-4f)];
        Assert.Equal(new(1, 0), At(Patch(""), new(2, 0, 0)));
        MeshDescription stretched = Patch("\"point2 uv\" [0 0  3 0  0 5  3 5]");
        Assert.Equal((4, new(3, 0), new(0, 5)), (stretched.Positions.Count, At(stretched, new(2, 0, 0)), At(stretched, new(0, 2, 0))));

        // Corners that change places twist what lies between them: its middle is that of all four.
        MeshDescription twisted = Patch("\"point2 uv\" [0 0  1 0  1 1  0 1]");
        Assert.Equal((new(0, 1), new(0.5f, 0.5f), new(0.5f, 0)), (At(twisted, new(2, 2, 0)), At(twisted, new(1, 1, 0)), At(twisted, new(1, 0, 0))));
    }

    [Fact]
    public void Lights_have_the_units_of_pbrt()
    {
        SceneDescription scene = PbrtTestScene.Of("""
            LightSource "infinite" "float illuminance" 6.2831853
            LightSource "infinite" "rgb L" [1 0 0] "float scale" 3
            LightSource "point" "rgb I" [2 1 1] "float power" 12.5663706 "point3 from" [1 2 3]
            LightSource "distant" "blackbody L" 3000 "float illuminance" 5 "point3 to" [0 -1 0]
            LightSource "spot" "float coneangle" 60 "float conedeltaangle" 60 "float power" 3.14159265
            """);
        Assert.Equal(new(5, 2, 2), scene.Background);
        Assert.Equal((new(1, 2, 3), 2f), (((PointLightDescription)scene.Lights[0]).Position, ((PointLightDescription)scene.Lights[0]).Intensity.R));
        DirectionalLightDescription sun = (DirectionalLightDescription)scene.Lights[1];
        Assert.Equal(5, sun.Irradiance.Luminance, 1e-3);
        Assert.Equal(new(0, -1, 0), sun.Direction);

        // From 1 at the axis to ½ at 60°, on average ¾ of the cosine: a solid angle of 2π/4.
        SpotLightDescription spot = (SpotLightDescription)scene.Lights[2];
        Assert.Equal((2f, 60f, 0f, SpotFalloff.Smoothstep), (MathF.Round(spot.Intensity.G, 4), spot.CutoffAngle, spot.BeamWidth!.Value, spot.Falloff));
    }

    [Fact]
    public void Each_triangle_of_a_mesh_has_its_power()
    {
        MeshDescription mesh = (MeshDescription)PbrtTestScene.Of("""
            AreaLightSource "diffuse" "float power" 3.14159265
            Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0 0 4 0] "integer indices" [0 1 2 0 1 3]
            """).Shapes[0];
        Assert.Equal([2f, 0.5f], mesh.MaterialOfTriangle.Select(i => Radiance(mesh.Materials[i])));
    }

    [Fact]
    public void Roughness_is_the_square_of_alpha_unless_it_is_said_to_be_alpha()
    {
        RoughConductorMaterialDescription metal = (RoughConductorMaterialDescription)MaterialOf("\"conductor\" \"float uroughness\" 0.25 \"float vroughness\" 0.01");
        Assert.Equal((Metal.Copper, 0.5f, 0.1f), (metal.Metal!.Value, Number(metal.AlphaU!), Number(metal.AlphaV!)));
        RoughDielectricMaterialDescription glass = (RoughDielectricMaterialDescription)MaterialOf("\"dielectric\" \"float roughness\" 0.25 \"bool remaproughness\" false \"float eta\" 1.3");
        Assert.Equal((0.25f, 1.3f), (Number(glass.Alpha), glass.RefractiveIndex));
        Assert.Equal(Glass.Sf11, ((DielectricMaterialDescription)MaterialOf("\"dielectric\" \"spectrum eta\" \"glass-SF11\"")).Glass);
        ConductorMaterialDescription mirror = (ConductorMaterialDescription)MaterialOf("\"conductor\" \"rgb reflectance\" [0.5 0.2 0]");
        Assert.Equal((1f, 2f), (mirror.Eta!.Value.R, MathF.Round(mirror.K!.Value.R, 4)));
    }

    // By another way: terms of light that goes down, is thrown back n times, and comes out, each with its losses.
    [Theory]
    [InlineData(1.5f, 0.01f, 0.5f)]
    [InlineData(1.5f, 0f, 0.8f)]
    [InlineData(1.3f, 0.2f, 0.9f)]
    public void A_matt_base_is_darker_by_what_its_coat_absorbs(float index, float thickness, float reflectance)
    {
        PlasticMaterialDescription plastic = (PlasticMaterialDescription)MaterialOf(FormattableString.Invariant(
            $"\"coateddiffuse\" \"float eta\" {index} \"float thickness\" {thickness} \"rgb reflectance\" [{reflectance} {reflectance} {reflectance}]"));
        (double back, double out1, double both) = (0, 0, 0);
        const int steps = 20_000;
        for (int i = 0; i < steps; i++)
        {
            double cosine = (i + 0.5) / steps;
            double sine = index * Math.Sqrt(1 - (cosine * cosine));
            double outside = sine < 1 ? Math.Sqrt(1 - (sine * sine)) : 0;
            double s = ((index * cosine) - outside) / ((index * cosine) + outside);
            double p = ((index * outside) - cosine) / ((index * outside) + cosine);
            double fresnel = sine < 1 ? ((s * s) + (p * p)) / 2 : 1;
            double weight = 2 * cosine / steps;
            back += weight * fresnel;
            both += weight * fresnel * Math.Exp(-2 * thickness / cosine);
            out1 += weight * (1 - fresnel) * Math.Exp(-thickness / cosine);
        }

        double way = Math.Pow(out1 / (1 - back), 2);
        double expected = Enumerable.Range(0, 200).Sum(n => way * reflectance * Math.Pow(reflectance * both, n));
        double color = Number(plastic.Color);
        Assert.Equal(expected, color / (1 - (color * back)), 2e-3);
        Assert.True(plastic.Nonlinear);
    }

    [Fact]
    public void Parts_of_quadrics_become_meshes_with_the_uv_and_the_front_of_pbrt()
    {
        MeshDescription part = (MeshDescription)PbrtTestScene.Of("Shape \"sphere\" \"float radius\" 2 \"float zmin\" 0 \"float phimax\" 90").Shapes[0];
        int last = part.Positions.Count - 1;
        Assert.Equal(new(1, 1), part.Uv[last]);
        Assert.Equal(new(0, 0, 2), Rounded(part.Positions[last]));
        Assert.Equal(new(2, 0, 0), Rounded(part.Positions[0]));
        Assert.All(part.Triangles, t => Assert.True(Front(part, t).Dot(part.Positions[t.A]) > 0));
        MeshDescription ring = (MeshDescription)PbrtTestScene.Of("Shape \"disk\" \"float innerradius\" 0.5 \"float height\" 3").Shapes[0];
        Assert.All(ring.Triangles, t => Assert.True(Front(ring, t).Z > 0));
        Assert.Equal(MathF.PI * 0.75, ring.Triangles.Sum(t => Front(ring, t).Norm() / 2), 2e-3);
    }

    [Fact]
    public void The_uv_of_a_sphere_are_those_of_pbrt()
    {
        SphereDescription sphere = (SphereDescription)PbrtTestScene.Of("""
            Texture "t" "spectrum" "checkerboard"
            Material "diffuse" "texture reflectance" "t" Shape "sphere"
            """).Shapes[0];
        float[] m = [.. Assert.Single(sphere.Transform).Matrix];

        // Ours has u = 0 at −z, ¼ at −x, and v = 1 at y; theirs at x, y and z.
        Assert.Equal((1f, 1f, 1f), (-m[2], -m[4], m[9]));
    }

    [Fact]
    public void Projections_say_what_goes_into_each_direction()
    {
        const string light = """LightSource "projection" "string filename" "p.png" "float fov" 60 "float scale" 2 """;
        ProjectorLightDescription projector = (ProjectorLightDescription)PbrtTestScene.Of(light).Lights[0];
        Assert.Equal((60, FieldOfViewAxis.Smaller, false, new Rgb(2, 2, 2)), (projector.FieldOfView, projector.FieldOfViewAxis, projector.EvenOnWalls, projector.Intensity));
        Assert.Equal((Vector3.UnitZ, Vector3.UnitY), (projector.Direction, projector.Up));

        // Looking along z with y upwards, x is to the right in pbrt's space, and to the left in ours.
        Assert.Equal(new Vector2(-1, 1), ((ImageTextureDescription)projector.Picture).Scale);
        projector = (ProjectorLightDescription)PbrtTestScene.Of("Scale -1 1 1 " + light).Lights[0];
        Assert.Equal(Vector2.One, ((ImageTextureDescription)projector.Picture).Scale);
    }

    [Fact]
    public void Subdivided_surfaces_are_meshes_that_are_refined()
    {
        const string shape = """Shape "loopsubdiv" "integer levels" 2 "point3 P" [0 0 0  1 0 0  0 1 0] "integer indices" [0 1 2] """;
        MeshDescription mesh = (MeshDescription)PbrtTestScene.Of(shape).Shapes[0];
        Assert.Equal(new RefinementDescription { Subdivide = 2, Scheme = SubdivisionScheme.Loop }, mesh.Refinement);
        Assert.True(mesh.FlipNormals);
        Assert.Contains("are subdivided by \"loop\"", PbrtTestScene.Complaint(shape + "\"string scheme\" \"butterfly\""), StringComparison.Ordinal);
    }

    [Fact]
    public void Patches_are_shaded_by_the_normals_of_their_corners()
    {
        MeshDescription patch = (MeshDescription)PbrtTestScene.Of("""
            Shape "bilinearmesh" "point3 P" [0 0 0  2 0 0  0 2 0  2 2 0] "normal N" [0 0 -1  1 0 0  0 0 -1  1 0 0]
            """).Shapes[0];
        int middle = patch.Positions.ToList().FindIndex(p => (p - new Vector3(1, 1, 0)).Norm() < 1e-5f);
        Assert.True((patch.Normals[middle] - new Vector3(1, 0, -1).Unit()).Norm() < 1e-5f);
        Assert.All(patch.Triangles, t => Assert.True((patch.Positions[t.B] - patch.Positions[t.A]).Cross(patch.Positions[t.C] - patch.Positions[t.A]).Z < 0));
    }

    [Fact]
    public void Grids_send_what_they_absorb_of_their_radiance()
    {
        MaterialDescription material = PbrtTestScene.Of("""
            MakeNamedMedium "fire" "string type" "uniformgrid" "integer nx" 1 "integer ny" 1 "integer nz" 1 "float density" [1]
                "rgb sigma_a" [2 1 0] "rgb sigma_s" [1 1 1] "rgb Le" [1 1 1] "float Lescale" 3
            AttributeBegin MediumInterface "fire" "" Material "interface" Shape "sphere" AttributeEnd
            """).Shapes[0].Material;
        Rgb emission = ((InvisibleMaterialDescription)material).Interior.Emission;
        Assert.True(Math.Abs(emission.R - 6) < 1e-5 && Math.Abs(emission.G - 3) < 1e-5 && emission.B == 0, $"{emission}");
    }

    [Fact]
    public void Grids_of_factors_say_where_a_medium_shines()
    {
        const string fire = """
            MakeNamedMedium "fire" "string type" "uniformgrid" "integer nx" 2 "integer ny" 1 "integer nz" 1 "float density" [2 3]
                "rgb sigma_a" [2 1 0] "rgb sigma_s" [1 1 1] "rgb Le" [1 1 1] "float Lescale" [0.5 4]
            AttributeBegin MediumInterface "fire" "" Material "interface" Shape "sphere" AttributeEnd
            """;
        MediumDescription read = PbrtTestScene.Filled(fire);
        Assert.True(Math.Abs(read.Emission.R - 2) < 1e-5 && Math.Abs(read.Emission.G - 1) < 1e-5 && read.Emission.B == 0, $"{read.Emission}");
        Assert.Equal([1f, 12], read.EmissionGrid!.Values.Skip(17).Take(2));
        Assert.Equal(13, read.EmissionGrid.Values.Sum());
        Assert.Equal(read.Density!.Size, read.EmissionGrid.Size);
        Assert.Equal(read.Density.Box, read.EmissionGrid.Box);

        // Factors colour temperatures as well, and of what does not shine there is nothing to say.
        read = PbrtTestScene.Filled(fire.Replace("\"rgb Le\" [1 1 1]", "\"float temperature\" [900 1200]", StringComparison.Ordinal));
        Assert.Equal((1200, 12), (read.TemperatureGrid!.Values[18], read.EmissionGrid!.Values[18]));
        read = PbrtTestScene.Filled(fire.Replace("\"rgb Le\" [1 1 1]", "", StringComparison.Ordinal));
        Assert.Equal((null, true), (read.EmissionGrid, read.Emission.IsBlack));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void NanoVdb_files_of_two_grids_glow_at_the_temperatures_of_the_second(int codec)
    {
        using TemporaryFolder folder = new();
        byte[] Grid(string name, float value, int last) => TestNanoVdb.File((0, 0, 0), (last, last, last), (x, _, _) => value + x, codec, name: name);
        string fire = $"""
            MakeNamedMedium "fire" "string type" "nanovdb" "string filename" "{TestVolumes.Write(folder["fire.nvdb"], [.. Grid("density", 1, 7), .. Grid("temperature", 10, 3)])}"
                "rgb sigma_a" [2 1 0] "rgb sigma_s" [0 0 0] "float Lescale" 3 "float temperaturescale" 100 "float temperatureoffset" 2
            AttributeBegin MediumInterface "fire" "" Material "interface" Shape "sphere" "float radius" 50 AttributeEnd
            """;
        MediumDescription read = PbrtTestScene.Filled(fire);
        Assert.Equal(("density", "temperature", 2, 100), (read.Density!.Name, read.TemperatureGrid!.Name, read.TemperatureOffset, read.TemperatureScale));

        // A scene of this program names both grids as well.
        string path = folder["fire.nvdb"].Replace('\\', '/');
        SceneReadResult native = SceneReader.ReadText($$"""
            { "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 50, "material": { "type": "invisible", "interior": { "extinction": [2, 1, 0], "albedo": 0, "emission": [6, 3, 0],
                "density": { "file": "{{path}}", "name": "density" }, "temperatureGrid": { "file": "{{path}}", "name": "temperature" }, "temperatureOffset": 2, "temperatureScale": 100 } } } ] }
            """, "fire.json");
        Assert.Empty(native.Diagnostics);
        foreach (MediumDescription medium in (MediumDescription[])[read, ((InvisibleMaterialDescription)native.Description!.Shapes[0].Material).Interior])
        {
            // Voxels are quarters of a unit. The first one has a density of 1 and 10 units of temperature, which are 800 K; the fifth, of a density of 5, lies outside of the other grid.
            VaryingMedium built = medium.Build(new(loadGrid: new VolumeFolder(".").Load))!.Varying!;
            built.Emission(new(FloatW.Iota + 0.5f, 0.5f, 0.5f), out RgbW emission);
            for (int lane = 0; lane < int.Min(8, FloatW.Count); lane++)
            {
                RgbW color = lane < 4 ? BlackBody.Color(800 + (100 * lane)) : default;
                Assert.Equal(((1 + lane) * 6 * color.R[0], (1 + lane) * 3 * color.G[0], 0), (emission.R[lane], emission.G[lane], emission.B[lane]));
            }
        }

        // Without the second grid, nothing glows.
        TestVolumes.Write(folder["fire.nvdb"], Grid("density", 1, 7));
        Assert.Equal((null, true), (PbrtTestScene.Filled(fire).TemperatureGrid, PbrtTestScene.Filled(fire).Emission.IsBlack));
    }

    [Fact]
    public void Grids_of_temperatures_colour_what_a_medium_sends()
    {
        const string fire = """
            MakeNamedMedium "fire" "string type" "uniformgrid" "integer nx" 1 "integer ny" 1 "integer nz" 1 "float density" [1] "float temperature" [12]
                "rgb sigma_a" [2 1 0] "rgb sigma_s" [1 1 1] "float Lescale" 3 "float temperaturescale" 100 "float temperatureoffset" 2
            AttributeBegin MediumInterface "fire" "" Material "interface" Shape "sphere" AttributeEnd
            """;
        MediumDescription read = ((InvisibleMaterialDescription)PbrtTestScene.Of(fire).Shapes[0].Material).Interior;
        Assert.Equal((2f, 100f, 27), (read.TemperatureOffset, read.TemperatureScale, read.TemperatureGrid!.Values.Count));
        Assert.Equal(12, read.TemperatureGrid.Values[13]);
        Assert.True(Math.Abs(read.Emission.R - 6) < 1e-5 && Math.Abs(read.Emission.G - 3) < 1e-5, $"{read.Emission}");
        read = ((InvisibleMaterialDescription)PbrtTestScene.Of(fire.Replace("Lescale\" 3", "Lescale\" 0", StringComparison.Ordinal)).Shapes[0].Material).Interior;
        Assert.Equal((null, 0f, 1f, true), (read.TemperatureGrid, read.TemperatureOffset, read.TemperatureScale, read.Emission.IsBlack));
    }

    [Fact]
    public void A_coat_of_two_roughnesses_has_their_mean_where_scenes_are_read_leniently()
    {
        ImportSettings.IsLenient = true;
        using PbrtTestScene scene = new();
        SceneReadResult read = PbrtReader.Read(scene.Write("scene.pbrt", """Material "coateddiffuse" "float uroughness" 0.1 "float vroughness" 0.4 "bool remaproughness" false Shape "sphere" """));
        Assert.Equal(Severity.Warning, Assert.Single(read.Diagnostics).Severity);
        Assert.Equal(0.2f, ((RoughPlasticMaterialDescription)read.Description!.Shapes[0].Material).Alpha, 1e-6f);
    }

    [Fact]
    public void Metal_under_a_coat_has_the_roughness_of_both()
    {
        CoatedConductorMaterialDescription metal = (CoatedConductorMaterialDescription)MaterialOf(
            "\"coatedconductor\" \"float interface.roughness\" 0.04 \"float conductor.roughness\" 0.25 \"float interface.eta\" 1.4 \"spectrum conductor.eta\" \"metal-Au-eta\" \"spectrum conductor.k\" \"metal-Au-k\"");
        Assert.Equal((0.5f, 0.2f, 1.4f, new Rgb(0.01f, 0.01f, 0.01f), Metal.Gold), (metal.Alpha, MathF.Round(metal.CoatAlpha, 6), metal.CoatIndex, metal.CoatAbsorption, metal.Metal!.Value));
        metal = (CoatedConductorMaterialDescription)MaterialOf("\"coatedconductor\" \"rgb reflectance\" [0.5 0.5 0.5]");
        Assert.Equal((0f, 0f, 2f), (metal.Alpha, metal.CoatAlpha, MathF.Round(metal.K!.Value.R, 4)));
        Assert.Equal(Metal.Copper, ((CoatedConductorMaterialDescription)MaterialOf("\"coatedconductor\"")).Metal);
    }

    // A picture whose directions have z as their pole, or y for goniometric lights, which pbrt exchanges.
    [Theory]
    [InlineData("goniometric", 0, 1, 0)]
    [InlineData("infinite", 0, 0, 1)]
    public void Pictures_of_all_directions_have_their_middle_at_their_pole(string type, float x, float y, float z)
    {
        string light = $"AttributeBegin Rotate 90 0 0 1 LightSource \"{type}\" \"string filename\" \"p.exr\" \"float scale\" 2 AttributeEnd";
        SceneDescription scene = PbrtTestScene.Of(light);
        IReadOnlyList<TransformDescription> steps = scene.Environment?.Transform ?? scene.Lights[0].Transform;
        float[] m = [.. Assert.Single(steps).Matrix];
        Vector3 Of(Vector3 d) => Rounded(new((m[0] * d.X) + (m[1] * d.Y) + (m[2] * d.Z), (m[4] * d.X) + (m[5] * d.Y) + (m[6] * d.Z), (m[8] * d.X) + (m[9] * d.Y) + (m[10] * d.Z)));

        // Turned by 90° about z: what is towards x in the picture is towards y, and y towards −x.
        Assert.Equal(new Vector3(0, 1, 0), Of(Vector3.UnitX));
        Assert.Equal(type == "infinite" ? new Vector3(x, y, z) : new Vector3(-y, x, 0), Of(Vector3.UnitY));

        // The lower half of the picture is towards pbrt's y, or z.
        Assert.Equal(type == "infinite" ? new Vector3(-1, 0, 0) : new Vector3(0, 0, 1), Of(-Vector3.UnitZ));
        ImageEnvironmentDescription? around = scene.Environment as ImageEnvironmentDescription;
        Assert.Equal((DirectionMapping.Octahedral, 2f), around is not null ? (around.Mapping, around.Scale) : (((PointLightDescription)scene.Lights[0]).Mapping, ((PointLightDescription)scene.Lights[0]).Intensity.G));
    }

    [Fact]
    public void Textures_of_noise_are_in_the_space_of_the_texture()
    {
        SceneDescription scene = PbrtTestScene.Of("""
            AttributeBegin Translate 1 2 3
            Texture "stone" "spectrum" "marble" "float scale" 4 "integer octaves" 5 "float roughness" 0.6 "float variation" 0.7
            Texture "waves" "float" "windy" AttributeEnd
            Texture "bumps" "float" "wrinkled" "integer octaves" 3
            Texture "spots" "spectrum" "dots" "rgb inside" [1 0 0] "float uscale" 3 "float vscale" 4
            """);
        PerlinTextureDescription stone = (PerlinTextureDescription)scene.Textures["stone"];
        Assert.Equal((PerlinPattern.Marble, TextureSpace.World, 5, 0.6f, 0.7f), (stone.Pattern, stone.Space, stone.Octaves, stone.Roughness, stone.Variation));
        Assert.Equal([0.25f, 0, 0, 1, 0, 0.25f, 0, 2, 0, 0, 0.25f, 3], Assert.Single(stone.Transform).Matrix);
        Assert.Equal((PerlinPattern.Windy, 1f), (((PerlinTextureDescription)scene.Textures["waves"]).Pattern, ((PerlinTextureDescription)scene.Textures["waves"]).Transform[0].Matrix[0]));
        Assert.Equal((PerlinPattern.Wrinkled, 3), (((PerlinTextureDescription)scene.Textures["bumps"]).Pattern, ((PerlinTextureDescription)scene.Textures["bumps"]).Octaves));
        Assert.Equal(new Vector2(3, 4), ((DotsTextureDescription)scene.Textures["spots"]).Scale);
    }

    [Theory]
    [InlineData("bezier", 3, "0 0 0  0 0 1  0 0 2  0 0 3", 3, 0)]
    [InlineData("bezier", 2, "0 0 0  0 0 1  0 0 2  0 0 3  0 0 4", 4, 0)]
    [InlineData("bspline", 3, "0 0 0  0 0 1  0 0 2  0 0 3  0 0 4", 3, 1)]
    [InlineData("bspline", 2, "0 0 0  0 0 1  0 0 2  0 0 3  0 0 4", 3.5, 0.5)]
    public void Straight_curves_are_tubes(string basis, int degree, string points, double end, double start)
    {
        MeshDescription tube = (MeshDescription)PbrtTestScene.Of($"Shape \"curve\" \"string basis\" \"{basis}\" \"integer degree\" {degree} \"point3 P\" [{points}] \"float width0\" 0.2 \"float width1\" 0.4").Shapes[0];
        Assert.Equal((start, end), (Math.Round(tube.Positions.Min(p => p.Z), 4), Math.Round(tube.Positions.Max(p => p.Z), 4)));
        foreach ((Vector3 p, Vector3 n) in tube.Positions.Zip(tube.Normals))
        {
            double width = 0.2 + (0.2 * (p.Z - start) / (end - start));
            Assert.Equal(width / 2 * 1.02617, Math.Sqrt((p.X * p.X) + (p.Y * p.Y)), 1e-4);
            Assert.True((n - new Vector3(p.X, p.Y, 0).Unit()).Norm() < 1e-4f);
        }

        // Outside is in front, and the area is that of a round cone's side: the perimeter counts.
        Assert.All(tube.Triangles, t => Assert.True(Front(tube, t).Dot(tube.Normals[t.A] + tube.Normals[t.B] + tube.Normals[t.C]) > 0));
        Assert.Equal(Math.PI * 0.3 * (end - start), tube.Triangles.Sum(t => Front(tube, t).Norm() / 2), 0.02 * (end - start));
    }

    [Fact]
    public void Bent_curves_keep_their_width_and_do_not_twist()
    {
        MeshDescription tube = (MeshDescription)PbrtTestScene.Of("Shape \"curve\" \"point3 P\" [0 0 0  1 0 0  1 1 0  0 1 0   -1 1 0  -1 0 1  0 0 2] \"float width\" 0.1").Shapes[0];
        for (int i = 0; i < 17; i++)
        {
            // The mesh has the points of each side one after the other.
            Vector3[] ring = [.. Enumerable.Range(0, 8).Select(side => tube.Positions[(17 * side) + i])];
            Vector3 middle = ring.Aggregate((a, b) => a + b) / 8;
            Assert.All(ring, p => Assert.Equal(0.0513, (p - middle).Norm(), 1e-3));
            Assert.True(i == 0 || (tube.Normals[i] - tube.Normals[i - 1]).Norm() < 0.5f);
        }
    }

    [Fact]
    public void Ribbons_are_bands_across_their_normals()
    {
        MeshDescription band = (MeshDescription)PbrtTestScene.Of("""
            Shape "curve" "string type" "ribbon" "point3 P" [0 0 0  0 0 1  0 0 2  0 0 3] "normal N" [1 0 0  0 1 0] "float width" 0.5
            """).Shapes[0];
        Assert.Equal((18, 16), (band.Positions.Count, band.Triangles.Count));
        Assert.All(band.Positions, p => Assert.Equal(0.25, Math.Sqrt((p.X * p.X) + (p.Y * p.Y)), 1e-5));
        Assert.Equal(new(1, 0, 0), Rounded(band.Normals[0]));
        Assert.Equal(new(0.7071f, 0.7071f, 0), Rounded(band.Normals[4]));
        Assert.Equal(new(0, 1, 0), Rounded(band.Normals[8]));
        Assert.Equal(0.25f, MathF.Abs(band.Positions[0].Y), 1e-5f);
    }

    [Fact]
    public void Grids_of_colours_have_their_extinction_and_albedo_at_each_point()
    {
        MediumDescription medium = ((InvisibleMaterialDescription)PbrtTestScene.Of("""
            MakeNamedMedium "dye" "string type" "rgbgrid" "integer nx" 2 "integer ny" 1 "integer nz" 1 "float scale" 2 "float Lescale" 3
                "rgb sigma_a" [1 0 0  0 1 2] "rgb sigma_s" [1 1 0  0 3 2] "rgb Le" [5 0 0  0 0 1]
            MediumInterface "dye" "" Material "interface" Shape "sphere"
            """).Shapes[0].Material).Interior;
        Assert.Equal((new(2, 2, 2), Rgb.White, new(6, 6, 6)), (medium.Extinction, medium.Albedo, medium.Emission));
        Assert.Equal([4, 3, 3, 3], medium.Density!.Size);
        Assert.Equal([2f, 1, 0, 0, 4, 4], medium.Density.Values.Skip(3 * 17).Take(6));
        Assert.Equal(9 + 2, medium.Density.Values.Sum());
        Assert.Equal([0.5f, 1, 0, 0, 0.75f, 0.5f], medium.AlbedoGrid!.Values);
        Assert.Equal([new(0, 0, 0), new(1, 1, 1)], medium.AlbedoGrid.Box);
        Assert.Equal([5f, 0, 0, 0, 0, 2], medium.EmissionGrid!.Values.Skip(3 * 17).Take(6));
    }

    // pbrt's formula, on points of the grid.
    [Fact]
    public void Clouds_are_those_of_pbrts_formula()
    {
        MediumDescription medium = ((InvisibleMaterialDescription)PbrtTestScene.Of("""
            MakeNamedMedium "cloud" "string type" "cloud" "float density" 2 "float wispiness" 0.5 "float frequency" 4 "point3 p1" [1 1 2]
            MediumInterface "cloud" "" Material "interface" Shape "sphere"
            """).Shapes[0].Material).Interior;
        Assert.Equal((2f, 0.5f, 4f), (medium.Cloud!.Density, medium.Cloud.Wispiness, medium.Cloud.Frequency));
        PlacedGrid grid = (medium.Cloud with { Resolution = 16 }).Build(new())!;
        Assert.Equal((8, 8, 16), (grid.Grid.Width, grid.Grid.Height, grid.Grid.Depth));
        bool varies = false;
        for (int i = 0; i < 8 * 8 * 16; i += 5)
        {
            Vector3 p = new(((i % 8) + 0.5f) / 8, ((i / 8 % 8) + 0.5f) / 8, ((i / 64) + 0.5f) / 8);
            Vector3 at = p * 4;
            (float step, float frequency) = (0.05f * 0.5f, 10);
            for (int j = 0; j < 2; j++)
            {
                Vector3 q = at * frequency;
                float n = Noise(q);
                at += step * 100 * new Vector3(Noise(q + new Vector3(0.01f, 0, 0)) - n, Noise(q + new Vector3(0, 0.01f, 0)) - n, Noise(q + new Vector3(0, 0, 0.01f)) - n);
                (step, frequency) = (step / 2, frequency * 1.99f);
            }

            float sum = Enumerable.Range(0, 5).Sum(o => MathF.Pow(0.5f, o + 1) * Noise(at * MathF.Pow(1.99f, o)));
            float expected = Math.Clamp(Math.Clamp((1 - p.Y) * 4.5f * 2 * sum, 0, 1) + (2 * MathF.Max(0, 0.5f - p.Y)), 0, 1);
            grid.Value(new Vec3W((i % 8) + 0.5f, (i / 8 % 8) + 0.5f, (i / 64) + 0.5f), out RgbW value);
            Assert.Equal(expected, value.R[0], 2e-3);
            varies |= expected is > 0.01f and < 0.99f;
        }

        Assert.True(varies);
        static float Noise(Vector3 p) => GradientNoise.Tabled(p)[0];
    }

    [Fact]
    public void Things_move_from_one_transform_to_the_other()
    {
        SceneDescription scene = PbrtTestScene.Of("""
            ObjectBegin "o" Shape "disk" ObjectEnd
            AttributeBegin ActiveTransform EndTime Translate 3 0 0 ActiveTransform All Scale 2 2 2 Shape "sphere" ObjectInstance "o" AttributeEnd
            Shape "sphere"
            """, """
            TransformTimes 0.5 1.5 LookAt 0 0 -4 0 0 0 0 1 0 ActiveTransform EndTime Translate 1 0 0 ActiveTransform All
            Camera "perspective" "float shutteropen" 0.5 "float shutterclose" 1.5
            """);
        Assert.Equal(new Vector2(0.5f, 1.5f), scene.Render.Shutter);
        foreach (ShapeDescription moving in scene.Shapes.Take(2))
        {
            Assert.Empty(moving.Transform.SelectMany(t => t.Matrix));
            Assert.Equal([0.5f, 1.5f], moving.Motion.Select(k => k.Time));
            Assert.Equal([2, 0, 0, 0], moving.Motion[0].Transform[0].Matrix.Take(4));
            Assert.Equal([2, 0, 0, 3], moving.Motion[1].Transform[0].Matrix.Take(4));
        }

        Assert.Empty(scene.Shapes[2].Motion);

        // The camera goes the other way than its transform, which takes the world to it.
        Assert.Equal((0f, -1f), (scene.Camera.Motion[0].Transform[0].Matrix[3], scene.Camera.Motion[1].Transform[0].Matrix[3]));
        Assert.Equal(default, PbrtTestScene.Of("Shape \"sphere\"").Render.Shutter);
    }

    // A ball that shines and crosses the picture: its light is spread over the way.
    [Fact]
    public void What_moves_is_blurred()
    {
        const string camera = """LookAt 0 0 -4 0 0 0 0 1 0 Scale -1 1 1 Camera "orthographic" "float screenwindow" [-2 2 -0.5 0.5] """;
        const string film = """Film "rgb" "integer xresolution" 4 "integer yresolution" 1 PixelFilter "box" Sampler "independent" "integer pixelsamples" 4096 """;
        const string ball = """AreaLightSource "diffuse" "rgb L" [1 1 1] Translate -1.5 0 0 ActiveTransform EndTime Translate 3 0 0 ActiveTransform All Shape "sphere" "float radius" 0.5""";
        Film blurred = PbrtTestScene.Render(ball, film + camera);
        double all = Enumerable.Range(0, 4).Sum(x => (double)blurred.Mean(x, 0).G);
        Assert.Equal(Math.PI / 4, all, 0.02);
        Assert.Equal(blurred.Mean(0, 0).G, blurred.Mean(3, 0).G, 0.02);
        Assert.True(blurred.Mean(1, 0).G > 1.2 * blurred.Mean(0, 0).G);
    }

    [Fact]
    public void Triangles_face_where_their_normals_point()
    {
        MeshDescription mesh = (MeshDescription)PbrtTestScene.Of("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"normal N\" [0 0 -1 0 0 -1 0 0 -1]").Shapes[0];
        Assert.Equal(new TriangleIndices(0, 2, 1), mesh.Triangles[0]);
        Assert.True(((MeshDescription)PbrtTestScene.Of("ReverseOrientation Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]").Shapes[0]).FlipNormals);
    }

    [Fact]
    public void Media_fill_shapes_and_fade_beyond_their_outermost_points()
    {
        SceneDescription scene = PbrtTestScene.Of("""
            MakeNamedMedium "smoke" "string type" "uniformgrid" "integer nx" 2 "integer ny" 1 "integer nz" 1 "float density" [3 5]
                "point3 p0" [0 0 0] "point3 p1" [2 1 1] "rgb sigma_a" [1 2 0] "rgb sigma_s" [3 2 0] "float scale" 2 "float g" 0.5
            MediumInterface "smoke" "" Material "interface" Shape "sphere"
            """);
        MediumDescription medium = ((InvisibleMaterialDescription)scene.Shapes[0].Material).Interior;
        Assert.Equal((new(8, 8, 0), new(0.75f, 0.5f, 0), 0.5f), (medium.Extinction, medium.Albedo, medium.Anisotropy));
        GridDescription grid = medium.Density!;
        Assert.Equal([4, 3, 3], grid.Size);
        Assert.Equal([new(-1, -1, -1), new(3, 2, 2)], grid.Box);
        Assert.Equal([(17, 3f), (18, 5f)], grid.Values.Select((v, i) => (i, v)).Where(p => p.v > 0));
    }

    [Fact]
    public void Objects_and_their_instances_are_shared()
    {
        SceneDescription scene = PbrtTestScene.Of("""
            ObjectBegin "ball" Translate 1 0 0 Shape "sphere" ObjectEnd
            ObjectInstance "ball" Translate 0 2 0 ObjectInstance "ball"
            """);
        Assert.Same(((InstanceDescription)scene.Shapes[0]).Of, ((InstanceDescription)scene.Shapes[1]).Of);
        Assert.Equal(2, Assert.Single(((InstanceDescription)scene.Shapes[1]).Transform).Matrix[7]);
        Assert.Equal(new(1, 0, 0), ((SphereDescription)Assert.Single(((GroupDescription)scene.Objects["ball"]).Shapes)).Center);
    }

    [Fact]
    public void Included_files_may_be_compressed_and_imported_ones_change_nothing_around_them()
    {
        using PbrtTestScene scene = new();
        using (GZipStream zip = new(File.Create(scene["ball.pbrt.gz"]), CompressionLevel.Fastest))
        {
            zip.Write("Translate 1 0 0 Shape \"sphere\""u8);
        }

        SceneReadResult read = PbrtReader.Read(scene.Write("scene.pbrt", "Import \"ball.pbrt.gz\" Include \"ball.pbrt.gz\" Shape \"sphere\" Shape \"sphere\" \"float radius\" 2"));
        Assert.Equal("", Diagnostic.Format([.. read.Diagnostics]));
        Assert.Equal([1f, 1f, 1f, 1f], read.Description!.Shapes.Cast<SphereDescription>().Select(s => s.Center.X));
    }

    [Fact]
    public void Attributes_are_given_to_what_follows_unless_it_says_otherwise()
    {
        SceneDescription scene = PbrtTestScene.Of("""
            AttributeBegin Attribute "shape" "float radius" 3 Shape "sphere" Shape "sphere" "float radius" 2 Shape "disk" AttributeEnd Shape "sphere"
            """);
        Assert.Equal([3f, 2f, 3f, 1f], scene.Shapes.Select(s => s is DiskDescription disk ? disk.Radius : ((SphereDescription)s).Radius));
    }

    [Fact]
    public void Screens_and_crops_are_windows()
    {
        CameraDescription camera = PbrtTestScene.Of("", """
            Film "rgb" "integer xresolution" 200 "integer yresolution" 100 "float cropwindow" [0.5 1 0 0.5]
            Camera "perspective" "float fov" 90 "float screenwindow" [-1 3 -1 1]
            """).Camera;

        // Half as wide again as from −3 to 3; of what is shown, the upper right quarter.
        Assert.Equal([0.6667f, 0f, 0.3333f, 0.5f], camera.Window.Select(w => MathF.Round(w, 4)));
        Assert.Equal(90, camera.FieldOfView, 1e-3);
    }

    [Fact]
    public void Settings_of_pictures_are_those_of_pbrt()
    {
        RenderDescription usual = PbrtTestScene.Of("").Render;
        Assert.Equal((1280, 720, 16, Integrator.VolPath, 6), (usual.Width, usual.Height, usual.SamplesPerPixel, usual.Integrator, usual.MaxDepth));
        Assert.Equal((FilterShape.Gaussian, 1.5f, 0.5f), (usual.Filter.Shape, usual.Filter.Radius, usual.Filter.Deviation));
        RenderDescription own = PbrtTestScene.Of("", "Integrator \"path\" \"integer maxdepth\" 3 Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 3").Render;
        Assert.Equal((9, SamplerKind.Jittered, Integrator.Path, 4), (own.SamplesPerPixel, own.Sampler, own.Integrator, own.MaxDepth));
    }

    [Fact]
    public void Colours_of_wider_spaces_become_those_of_sRGB()
    {
        SceneDescription scene = PbrtTestScene.Of("ColorSpace \"rec2020\" LightSource \"point\" \"rgb I\" [1 1 1] LightSource \"point\" \"rgb I\" [0.7 0.6 0.5]");
        Rgb white = ((PointLightDescription)scene.Lights[0]).Intensity;
        Rgb warm = ((PointLightDescription)scene.Lights[1]).Intensity;
        Assert.Equal((1, 1, 1), (Math.Round(white.R, 4), Math.Round(white.G, 4), Math.Round(white.B, 4)));

        // Of rec2020, the luminance is 0.2627 R + 0.6780 G + 0.0593 B.
        Assert.Equal((0.7 * 0.2627) + (0.6 * 0.678) + (0.5 * 0.0593), warm.Luminance, 1e-3);
    }

    [Theory]
    [InlineData("Shape \"cube\"", "a magenta ball is shown instead")]
    [InlineData("Material \"hair\" Shape \"sphere\"", "magenta is shown instead")]
    [InlineData("LightSource \"laser\"", "it is left out")]
    public void What_is_not_supported_has_a_stand_in_where_that_is_wanted(string things, string standIn)
    {
        Assert.DoesNotContain(standIn, PbrtTestScene.Complaint(things), StringComparison.Ordinal);
        ImportSettings.IsLenient = true;
        using PbrtTestScene scene = new();
        SceneReadResult read = PbrtReader.Read(scene.Write("scene.pbrt", things));
        Diagnostic warning = Assert.Single(read.Diagnostics);
        Assert.Equal(Severity.Warning, warning.Severity);
        Assert.EndsWith(standIn, warning.Message, StringComparison.Ordinal);
    }

    private static Vector3 Front(MeshDescription mesh, TriangleIndices t) => (mesh.Positions[t.B] - mesh.Positions[t.A]).Cross(mesh.Positions[t.C] - mesh.Positions[t.A]);

    private static Vector3 Rounded(Vector3 v) => new(MathF.Round(v.X, 4), MathF.Round(v.Y, 4), MathF.Round(v.Z, 4));

    private static MaterialDescription MaterialOf(string material) => PbrtTestScene.Of($"Material {material} Shape \"sphere\"").Shapes[0].Material;

    private static float Number(TextureDescription texture) => ((SolidTextureDescription)texture).Color.R;

    private static float Radiance(MaterialDescription material) => MathF.Round(Number(((LuminaireMaterialDescription)material).Color), 4);
}
