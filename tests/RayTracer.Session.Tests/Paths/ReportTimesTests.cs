using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class ReportTimesTests
{
    [Fact]
    public void Nothing_is_measured_any_more_when_the_session_has_ended()
    {
        TestSession test = new();
        ReportTimes times = test.Session.Part<ReportTimes>();
        Task measured = times.Measure();
        test.Dispose();
        Assert.True(measured.IsCanceled);
        Assert.True(times.Measure().IsCanceled);
    }
}
