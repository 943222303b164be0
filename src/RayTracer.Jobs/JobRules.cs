using RayTracer.Imaging;

namespace RayTracer.Jobs;

/// <summary>The rules of what does not go together in a job, for all faces.</summary>
public static class JobRules
{
    // Each row: two things that are not to be true at once, and the sentence. A thing is an option, or one of Facts; "a|b" is any of them,
    // "!a" its absence. The first row that applies is
    // shown. {a} is what is known of a, with its name where it is an option.
    private static readonly (string If, string And, string Sentence)[] s_rows =
    [
        ("several frames", "--pixel", "--pixel prints one picture's numbers: give one frame"),
        ("several frames", "--checkpoint", "--checkpoint is for one picture: of several frames, finished ones are kept anyway, and the same command renders the others"),
        ("several frames", "--preview", "--preview shows one picture: give one frame"),
        ("several frames", "nowhere", "where to? Give -o frame-####.png"),
        ("several frames", "one file", "-o {one file}: {several frames} frames need as many files: put #### where their numbers should go"),
        ("several frames", "too many parts", "{--part}: with --frames, frames are divided among parts, and {several frames} frames make at most {several frames} parts"),
        ("only an animated PNG", "--denoise", "--denoise writes images beside every frame, and only an animated PNG is written: give -o frame-####.png too"),
        ("only an animated PNG", "--aov", "--aov writes images beside every frame, and only an animated PNG is written: give -o frame-####.png too"),
        ("an animated PNG", "--part", "an animated PNG has all frames: leave --part out"),
        ("nowhere", "!--pixel", "where to? Give -o FILE (or --json alone for the numbers, or --pixel x,y)"),
        ("--pixel", "files", "--pixel prints numbers and writes no image: leave -o out"),
        ("--pixel", "--crop", "--pixel and --crop cannot go together"),
        ("--pixel", "images of all pixels", "--pixel prints numbers and writes no image: leave --aov out, but for --aov strategies"),
        ("--pixel", "--denoise", "--pixel prints numbers and writes no image: leave --denoise out"),
        ("--denoise", "!files", "--denoise writes an image: where to? Give -o FILE"),
        ("--aov", "nowhere to write", "--aov writes images: where to? Give -o FILE"),
        ("--pixel", "--noise|--adaptive", "--pixel renders a given number of samples: leave --noise and --adaptive out"),
        ("--adaptive", "--samples|--part", "--adaptive decides how many samples there are: leave --samples and --part out"),
        ("--preview", "--pixel", "--pixel prints numbers: leave --preview out"),
        ("--adaptive", "passes", "--adaptive gives pixels different numbers of samples, which films in files, --checkpoint and --time cannot resume: leave it out"),
        ("--edition", "--pixel|--denoise|--halves|--noise|--adaptive|--guide|--transparent", "{--edition}: the textbook edition makes pictures and films only: leave --pixel, --denoise, --halves, --noise, --adaptive, --guide and --transparent out"),
        ("--edition", "images of all pixels|layers of light", "{--edition}: the textbook edition makes pictures and films only: leave --aov out"),
        ("--guide-file", "!--guide", "--guide-file keeps what --guide learns: give --guide too"),
        ("several frames", "--guide-file", "--guide-file keeps what is learned of one picture: give one frame, or leave it out"),
        ("--noise", "--samples|--part", "--noise decides how many samples there are: leave --samples and --part out"),
        ("--samples", "--part", "--samples and --part cannot go together"),
        ("--pixel", "--samples|--part|--time|--checkpoint", "--pixel goes with --sample only: leave --samples, --part, --time and --checkpoint out"),
        ("--halves", "no film in a file", "--halves is for films, but none is written: give -o FILE.rtfilm, --checkpoint FILE.rtfilm or --exr-film"),
        ("--checkpoint", "no film", "{--checkpoint}: films are written to .rtfilm files"),
        ("--resume", "!--checkpoint", "--resume continues from a checkpoint: give --checkpoint FILE"),
        ("--overwrite", "!--checkpoint", "--overwrite replaces a checkpoint: give --checkpoint FILE"),
        ("--overwrite", "--resume", "--overwrite begins from scratch, and --resume continues: leave one of them out"),
        ("--scale", "--width", "--scale and --width both give the size: leave one of them out"),
        ("--scale", "--height", "--scale and --height both give the size: leave one of them out"),
        ("--adaptive", "--crop", "--adaptive distributes samples over the whole picture: leave --crop out"),
        ("layers of light", "--resume", "layers of light are made with the samples, and a film that is resumed has some without them: leave one of them out"),
        ("layers of light", "--adaptive", "layers of light need equal numbers of samples, which --adaptive does not give: leave one of them out"),
        ("only films", "auxiliary images|--denoise", "--aov and --denoise write images, but only films are written: give -o FILE.png or another image too"),
        ("one frame", "--part", "{--part}: with --frames, frames are divided among parts: for a share of one frame's samples give --samples"),
        ("--fps", "!--frames", "--fps is for animated PNGs: give --frames"),
        (".apng", "!--frames", "-o {.apng}: an animated PNG is made of --frames"),
        ("--sample", "!--pixel", "--sample needs --pixel"),
        ("--transparent", "an animated PNG", "an animated PNG has no alpha: leave --transparent out, or give -o frame-####.png"),
        ("--transparent", "no alpha", "--transparent: {no alpha} has no alpha: write .png or .exr"),
        ("--exr-film", "no .exr", "--exr-film is for OpenEXR images, but none is written: give -o FILE.exr"),
    ];

    /// <summary>Returns a sentence on values of a job that do not go together, and what to do about it; null where all is well.</summary>
    /// <param name="job">The job.</param>
    /// <param name="more">Options of the face that are none of the job's, <c>--preview</c> and <c>--json</c>.</param>
    public static string? Complaint(RenderJob job, params string[] more)
    {
        Dictionary<string, string> facts = Facts(job, more);
        bool IsTrue(string things) => things.Split('|').Any(t => t[0] == '!' ? !facts.ContainsKey(t[1..]) : facts.ContainsKey(t));
        return s_rows.FirstOrDefault(r => IsTrue(r.If) && IsTrue(r.And)).Sentence is { } sentence
            ? facts.Aggregate(sentence, (text, fact) => text.Replace($"{{{fact.Key}}}", fact.Value, StringComparison.Ordinal)) : null;
    }

    private static Dictionary<string, string> Facts(RenderJob job, string[] more)
    {
        Dictionary<string, string> facts = JobOptions.All.Where(o => o.Text(job) is not null)
            .ToDictionary(o => o.Name, o => $"{o.Name} {o.Text(job)}", StringComparer.Ordinal);
        Array.ForEach(more, option => facts[option] = option);
        void Add(string name, bool isTrue, object? value = null) => _ = isTrue && facts.TryAdd(name, $"{value}");
        bool isAnimation = FrameFiles.MakeAnimation(job);
        bool isSequence = FrameFiles.AreSeveral(job);
        string? single = job.Outputs.FirstOrDefault(o => !FrameFiles.IsNumbered(o) && !FrameFiles.IsAnimated(o, job.Frames));
        string? apng = job.Outputs.FirstOrDefault(AnimatedPng.IsNamed);
        Add("files", job.Outputs.Count > 0);
        Add("nowhere", job.Outputs.Count == 0 && job.Checkpoint is null && !more.Contains("--json"));
        Add("passes", job.KeepsFilm);
        Add("auxiliary images", job.Aovs.Count > 0 || job.Strategies);
        Add("images of all pixels", job.Aovs.Count + job.Layers.Count > 0);
        Add("nowhere to write", job.Outputs.Count == 0 && job.Pixel is null);
        Add("layers of light", job.Layers.Count > 0 || job.Strategies);
        Add("only films", job.Outputs.Count > 0 && job.Outputs.All(FilmFile.IsNamed));
        Add("no film", job.Checkpoint is { } checkpoint && !FilmFile.IsNamed(checkpoint));
        Add("no film in a file", !job.HasFilmFile);
        Add("no .exr", !job.Outputs.Any(FilmExr.IsNamed));
        Add("several frames", isSequence, job.Frames?.Count);
        Add("one frame", job.Frames is not null && !isSequence);
        Add("one file", single is not null, single);
        Add("too many parts", job.Part?.Count > job.Frames?.Count);
        Add("an animated PNG", isAnimation);
        Add("only an animated PNG", isAnimation && job.Outputs.All(o => FrameFiles.IsAnimated(o, job.Frames)));
        Add(".apng", apng is not null, apng);
        string? opaque = job.Outputs.FirstOrDefault(o => ImageFormat.OfName(o) is { } format && !format.Features.HasFlag(ImageFeatures.Alpha));
        Add("no alpha", opaque is not null, opaque is null ? null : $"{opaque}, {ImageFormat.OfName(opaque)!.FileName},");
        return facts;
    }
}
