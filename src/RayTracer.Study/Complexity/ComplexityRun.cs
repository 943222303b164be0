using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Study;

/// <summary><c>raytracer reproduce complexity</c>: measures, and writes chart and pages.</summary>
/// <param name="plan">The numbers of triangles.</param>
/// <param name="folder">The folder to write to; made if it is missing.</param>
/// <param name="output">Takes each result.</param>
internal sealed class ComplexityRun(ComplexityPlan plan, string folder, TextWriter output)
{
    /// <summary>Does everything.</summary>
    /// <exception cref="JobException">The folder cannot be used.</exception>
    /// <exception cref="OperationCanceledException">It was stopped; nothing was written.</exception>
    public void Run(CancellationToken cancellation)
    {
        Machine machine = Machine.Now();
        OutputFolder files = new(folder, output);
        files.Prepare(ComplexityPage.ChartFile);
        ComplexityStudy study = new(plan);
        study.Run((method, point) => Report(method, point, "ray"), cancellation);
        ComplexityStudy picture = ComplexityStudy.OfPicture(plan);
        picture.Run((method, point) => Report(method, point, "pixel"), cancellation);
        foreach ((string file, _, Func<Picture> make) in TwoWays.Pictures)
        {
            ImageFile.Write(files[file], make());
        }

        ComplexityPage page = new(plan, study, picture, machine);
        files.Write(ComplexityPage.ChartFile, SvgChart.Draw([page.Panel]));
        files.Write(ComplexityPage.PictureChartFile, SvgChart.Draw([page.PicturePanel]));
        files.WritePages(ComplexityPage.Title, page.Write);
    }

    private void Report(Method method, ComplexityPoint point, string unit) =>
        output.WriteLine(
            $"{point.Triangles} triangles, {method.Name}: {point.NanosecondsPerRay:F0} ns a {unit}, built in {point.BuildSeconds:F3} s");
}
