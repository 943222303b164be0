using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>Reads films, filters, samplers and integrators.</summary>
internal sealed class PbrtFilms(PbrtWorld world)
{
    /// <summary>How sensitive the film is: the part of the imaging ratio that it has.</summary>
    public float Sensitivity { get; } = (world.Only.GetValueOrDefault("film")?.Float("iso", 100, 0) ?? 100) / 100;

    /// <summary>The settings of a picture.</summary>
    public FilmRead Read(RenderDescription render)
    {
        render = Integrator(world.Only.GetValueOrDefault("integrator"), render);
        render = Sampler(world.Only.GetValueOrDefault("sampler"), render);
        render = render with { Filter = Filter(world.Only.GetValueOrDefault("filter")) };
        return Film(world.Only.GetValueOrDefault("film"), render);
    }

    private static FilmRead Film(PbrtThing? film, RenderDescription render)
    {
        render = render with { Width = 1280, Height = 720 };
        if (film is null)
        {
            return new(render, []);
        }

        if (film.Type is not ("rgb" or "gbuffer"))
        {
            film.UnknownType(["rgb", "gbuffer"]);
        }
        else if (film.Type == "gbuffer")
        {
            film.Log.Warn(film.Place, "auxiliary images are chosen with --aov, not in the scene");
        }

        film.Ignore("filename", "diagonal", "savefp16", "coordinatesystem", "iso");
        film.Refuse("maxcomponentvalue", "light is not cut off at a value here");
        film.Refuse("whitebalance", "a white balance is not supported");
        if (film.Text("sensor") is { } sensor and not "cie1931")
        {
            film.Log.Unsupported(film.PlaceOf("sensor"), $"the sensor {Quotation.Of(sensor)} is not supported: colours are those of \"cie1931\"", "it is used instead");
        }

        FilmRead read = Crop(film, render with { Width = film.Integer("xresolution", 1280, 1), Height = film.Integer("yresolution", 720, 1) });
        film.Finish();
        return read;
    }

    // By fractions of the picture, or else by pixels: x from and to, y from and to.
    private static FilmRead Crop(PbrtThing film, RenderDescription render)
    {
        (float width, float height) = (render.Width, render.Height);
        IReadOnlyList<float> part = film.Floats("cropwindow");
        int[] pixels = film.Integers("pixelbounds");
        if (part.Count == 0 && pixels.Length == 0)
        {
            return new(render, []);
        }

        float[] bounds = part is [var x0, var x1, var y0, var y1]
            ? [float.Ceiling(width * float.Min(x0, x1)), float.Ceiling(width * float.Max(x0, x1)), float.Ceiling(height * float.Min(y0, y1)), float.Ceiling(height * float.Max(y0, y1))]
            : pixels.Length == 4 ? [pixels[0], pixels[1], pixels[2], pixels[3]] : [];
        if (bounds is not [>= 0 and var left, var right, >= 0 and var top, var bottom] || right <= left || bottom <= top || right > width || bottom > height)
        {
            film.Log.Error(film.PlaceOf(part.Count > 0 ? "cropwindow" : "pixelbounds"), $"a crop has four numbers, x from and to and y from and to, within the film of {width}×{height} pixels");
            return new(render, []);
        }

        return new(
            render with { Width = (int)(right - left), Height = (int)(bottom - top) }, [left / width, top / height, (right - left) / width, (bottom - top) / height]);
    }

    private static FilterDescription Filter(PbrtThing? filter)
    {
        if (filter is null)
        {
            return new() { Shape = FilterShape.Gaussian, Radius = 1.5f, Deviation = 0.5f };
        }

        (FilterShape shape, float radius) = filter.Type switch
        {
            "box" => (FilterShape.Box, 0.5f),
            "triangle" => (FilterShape.Tent, 2),
            "mitchell" => (FilterShape.Mitchell, 2),
            _ => (FilterShape.Gaussian, 1.5f),
        };
        if (filter.Type is not ("box" or "triangle" or "mitchell" or "gaussian"))
        {
            filter.UnknownType(["box", "gaussian", "mitchell", "triangle"]);
        }

        float x = filter.Float("xradius", radius, 0, 16);
        if (filter.Float("yradius", radius, 0, 16) != x)
        {
            filter.Log.Unsupported(filter.Place, "a filter has one radius here, not two", "\"xradius\" counts");
        }

        FilterDescription read = new() { Shape = shape, Radius = x };
        read = shape switch
        {
            FilterShape.Gaussian => read with { Deviation = filter.Float("sigma", 0.5f, 0.01f, 16) },
            FilterShape.Mitchell => read with { B = filter.Float("B", 1f / 3, 0, 1), C = filter.Float("C", 1f / 3, 0, 1) },
            _ => read,
        };
        filter.Finish();
        return read;
    }

    private static RenderDescription Sampler(PbrtThing? sampler, RenderDescription render)
    {
        render = render with { SamplesPerPixel = 16, Sampler = SamplerKind.Sobol };
        if (sampler is null)
        {
            return render;
        }

        if (sampler.Type is not ("halton" or "sobol" or "paddedsobol" or "zsobol" or "pmj02bn" or "independent" or "stratified"))
        {
            sampler.UnknownType(["halton", "sobol", "paddedsobol", "zsobol", "pmj02bn", "independent", "stratified"]);
        }

        sampler.Ignore("randomization", "jitter");
        int seed = sampler.Integer("seed", 0, 0);
        int count = sampler.Type == "stratified"
            ? (int)long.Min((long)sampler.Integer("xsamples", 4, 1) * sampler.Integer("ysamples", 4, 1), 1 << 24) : int.Min(sampler.Integer("pixelsamples", 16, 1), 1 << 24);
        SamplerKind kind = sampler.Type switch
        {
            "independent" => SamplerKind.Independent,
            "stratified" when float.Sqrt(count) is var side && side == float.Floor(side) => SamplerKind.Jittered,
            _ => SamplerKind.Sobol,
        };
        sampler.Finish();
        return render with { SamplesPerPixel = count, Sampler = kind, Seed = seed };
    }

    private static RenderDescription Integrator(PbrtThing? integrator, RenderDescription render)
    {
        if (integrator is null)
        {
            return render with { Integrator = Description.Integrator.VolPath, MaxDepth = 6 };
        }

        // How it samples, which does not change the picture; and what ends paths, whose count of bounces is ours of edges less one.
        integrator.Ignore("lightsampler", "samplelights", "samplebsdf", "photonsperiteration", "visualizestrategies", "visualizeweights", "cossample", "rrthreshold");
        if (integrator.Boolean("regularize", false))
        {
            integrator.Log.Unsupported(integrator.PlaceOf("regularize"), "roughness is not changed to make caustics smoother here", "it is ignored");
        }

        Integrator? kind = integrator.Type switch
        {
            "volpath" or "simplevolpath" => Description.Integrator.VolPath,
            "path" or "simplepath" or "randomwalk" => Description.Integrator.Path,
            "bdpt" => Description.Integrator.Bidirectional,
            "lightpath" => Description.Integrator.Light,
            "sppm" => Description.Integrator.Photons,
            "ao" or "ambientocclusion" => Description.Integrator.Ao,
            _ => null,
        };
        if (kind is null)
        {
            integrator.UnknownType(["volpath", "path", "bdpt", "lightpath", "sppm", "simplepath", "simplevolpath", "randomwalk", "ambientocclusion"]);
        }

        int depth = int.Min(integrator.Integer("maxdepth", 5, 0), RenderDescription.LongestPath - 1);
        render = render with
        {
            Integrator = kind ?? Description.Integrator.VolPath,
            MaxDepth = depth + 1,
            MergeRadius = kind == Description.Integrator.Photons ? integrator.Float("radius", 1, 0) : 0,
            OcclusionDistance = kind == Description.Integrator.Ao && integrator.Float("maxdistance", float.MaxValue, 0) is < 1e30f and var far ? far : 0,
        };
        integrator.Finish();
        return render;
    }
}
