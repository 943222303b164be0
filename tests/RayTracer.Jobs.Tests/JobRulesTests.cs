namespace RayTracer.Jobs.Tests;

/// <summary>Each row of <see cref="JobRules"/> is shown for a job that breaks it, and for none that does not.</summary>
public sealed class JobRulesTests
{
    [Theory]
    [InlineData("--frames 0..9 --pixel 1,1 -o f#.png", "--pixel prints one picture's numbers: give one frame")]
    [InlineData("--frames 0..9 --checkpoint c.rtfilm -o f#.png", "--checkpoint is for one picture: of several frames, finished ones are kept anyway")]
    [InlineData("--frames 0..9", "where to? Give -o frame-####.png")]
    [InlineData("--frames 0..9 -o f.jpg", "-o f.jpg: 10 frames need as many files")]
    [InlineData("--frames 0..2 --part 1/4 -o f#.png", "--part 1/4: with --frames, frames are divided among parts, and 3 frames make at most 3 parts")]
    [InlineData("--frames 0..9 --denoise -o f.png", "--denoise writes images beside every frame, and only an animated PNG is written")]
    [InlineData("--frames 0..9 --aov depth -o f.apng", "--aov writes images beside every frame, and only an animated PNG is written")]
    [InlineData("--frames 0..9 --part 1/2 -o f.png", "an animated PNG has all frames: leave --part out")]
    [InlineData("", "where to? Give -o FILE")]
    [InlineData("--pixel 1,1 -o a.png", "--pixel prints numbers and writes no image: leave -o out")]
    [InlineData("--pixel 1,1 --crop 0,0,2,2", "--pixel and --crop cannot go together")]
    [InlineData("--pixel 1,1 --aov depth", "--pixel prints numbers and writes no image: leave --aov out")]
    [InlineData("--pixel 1,1 --denoise", "--pixel prints numbers and writes no image: leave --denoise out")]
    [InlineData("--checkpoint c.rtfilm --denoise", "--denoise writes an image: where to?")]
    [InlineData("--checkpoint c.rtfilm --aov depth", "--aov writes images: where to?")]
    [InlineData("--pixel 1,1 --noise 1%", "--pixel renders a given number of samples")]
    [InlineData("--pixel 1,1 --adaptive", "--pixel renders a given number of samples")]
    [InlineData("--adaptive --part 1/2 -o a.png", "--adaptive decides how many samples there are")]
    [InlineData("--adaptive --time 1m -o a.png", "--adaptive gives pixels different numbers of samples")]
    [InlineData("--adaptive -o a.rtfilm", "--adaptive gives pixels different numbers of samples")]
    [InlineData("--noise 1% --samples 0..3 -o a.png", "--noise decides how many samples there are")]
    [InlineData("--samples 0..3 --part 1/2 -o a.png", "--samples and --part cannot go together")]
    [InlineData("--pixel 1,1 --time 1m", "--pixel goes with --sample only")]
    [InlineData("--halves -o a.png", "--halves is for films, but none is written")]
    [InlineData("--checkpoint c.png -o a.png", "--checkpoint c.png: films are written to .rtfilm files")]
    [InlineData("--resume -o a.png", "--resume continues from a checkpoint: give --checkpoint FILE")]
    [InlineData("--adaptive --crop 0,0,2,2 -o a.png", "--adaptive distributes samples over the whole picture")]
    [InlineData("--aov lights --checkpoint a.rtfilm --resume -o a.exr", "layers of light are made with the samples")]
    [InlineData("--aov lights --adaptive -o a.exr", "layers of light need equal numbers of samples")]
    [InlineData("--aov depth -o a.rtfilm", "--aov and --denoise write images, but only films are written")]
    [InlineData("--frames 3 --part 1/2 -o a.png", "--part 1/2: with --frames, frames are divided among parts: for a share of one frame's samples give --samples")]
    [InlineData("--fps 10 -o a.png", "--fps is for animated PNGs: give --frames")]
    [InlineData("-o a.apng", "-o a.apng: an animated PNG is made of --frames")]
    [InlineData("--sample 3 -o a.png", "--sample needs --pixel")]
    [InlineData("--exr-film -o a.png", "--exr-film is for OpenEXR images, but none is written")]
    public void What_does_not_go_together_is_said(string words, string sentence) =>
        Assert.StartsWith(sentence, JobRules.Complaint(Job(words)), StringComparison.Ordinal);

    [Theory]
    [InlineData("--frames 0..9 -o f#.png", "--preview", "--preview shows one picture: give one frame")]
    [InlineData("--pixel 1,1", "--preview", "--pixel prints numbers: leave --preview out")]
    public void Options_of_a_face_count_too(string words, string option, string sentence)
    {
        Assert.Null(JobRules.Complaint(Job(words)));
        Assert.StartsWith(sentence, JobRules.Complaint(Job(words), option), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("-o a.png")]
    [InlineData("--pixel 1,1 --sample 3")]
    [InlineData("--noise 1% --adaptive -o a.png -o a.exr")]
    [InlineData("--part 1/4 -o part.rtfilm")]
    [InlineData("--frames 0..9 --part 1/4 -o f#.png")]
    [InlineData("--frames 3 -o a.png")]
    [InlineData("--frames 0..9 -o f.png --fps 25")]
    [InlineData("--aov depth,lights --denoise -o a.exr")]
    [InlineData("--adaptive --denoise -o a.exr")]
    [InlineData("--time 1m --checkpoint c.rtfilm --noise 2% --denoise -o a.exr -o a.rtfilm")]
    [InlineData("--checkpoint c.rtfilm --resume --time 1h")]
    [InlineData("--checkpoint c.rtfilm --resume --denoise -o a.png")]
    [InlineData("--halves --exr-film -o a.exr")]
    [InlineData("--exr-film --crop 0,0,2,2 -o a.exr")]
    public void What_goes_together_is_not_complained_about(string words) => Assert.Null(JobRules.Complaint(Job(words)));

    [Fact]
    public void Numbers_alone_need_no_file() => Assert.Null(JobRules.Complaint(Job(""), "--json"));

    private static RenderJob Job(string words) => OldFilms.OfWords(["scene.json", .. words.Split(' ', StringSplitOptions.RemoveEmptyEntries)], "the test");
}
