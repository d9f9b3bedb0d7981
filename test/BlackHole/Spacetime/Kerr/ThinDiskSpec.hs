module BlackHole.Spacetime.Kerr.ThinDiskSpec (spec) where

import BlackHole.Matter.ThinDisk (pageThorneFlux, peakRadius)
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.ThinDisk
import Support.Approx
import Support.KerrReference
import Test.Hspec

spec :: Spec
spec = do
  it "has the flux of 40 digits, down to the edge, and its peak" $ do
    rows <- kerrRows "kerr-flux.csv"
    length rows `shouldSatisfy` (> 30)
    sequence_
      [ do
          thinDiskFlux disk r `shouldBeWithin` (1e-11 * read flux, read flux)
          (thinDiskFlux disk r / snd (thinDiskPeak disk)) `shouldBeWithin` (1e-11 * read relative, read relative)
          if kind == "peak" then fst (thinDiskPeak disk) `shouldBeWithin` (1e-13 * r, r) else pure ()
        | [s, _, kind, radius, flux, relative] <- rows,
          let disk = thinDisk (spinOf (read s))
              r = read radius
      ]
  it "is the disk of a hole without spin" $ do
    let disk = thinDisk (spinOf 0)
    sequence_ [thinDiskFlux disk r `shouldBeWithin` (1e-14 * pageThorneFlux r, pageThorneFlux r) | r <- [3.2, 4, 5, 10, 100, 1e4]]
    fst (thinDiskPeak disk) `shouldBeWithin` (1e-13, peakRadius)
  it "goes over into it for slow holes" $
    sequence_
      [thinDiskFlux (thinDisk (spinOf s)) 6 `shouldBeWithin` (1e-3 * abs s, pageThorneFlux 6) | s <- [1e-3, -1e-6, 1e-9, -1e-12]]
  it "does not shine at and inside the innermost stable orbit, nor at infinity" $
    sequence_
      [ thinDiskFlux (thinDisk (spinOf s)) r `shouldBe` 0
        | s <- [-0.9, 0, 0.9, 0.9999],
          r <- [0, 0.5, iscoRadius RightHanded (spinOf s), 1 / 0, 0 / 0]
      ]
  it "falls off as 1/(8r³)" $
    sequence_ [(thinDiskFlux (thinDisk (spinOf s)) 1e12 * 8e36) `shouldBeWithin` (1e-5, 1) | s <- [-0.9, 0, 0.998]]
  it "is hottest at the peak" $ do
    let disk = thinDisk (spinOf 0.9)
        peak = fst (thinDiskPeak disk)
    relativeTemperature disk peak `shouldBeWithin` (1e-15, 1)
    map (relativeTemperature disk) [0.9 * peak, 1.1 * peak, 0.7 * peak] `shouldSatisfy` all (< 1)
