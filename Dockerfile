# docker build -t blackhole .
# docker run --rm --user "$(id -u)" -v "$PWD:/pictures" blackhole render -o hole.png
FROM debian:trixie-slim AS build
COPY . /blackhole
RUN /blackhole/script/package /package

FROM debian:trixie-slim
RUN --mount=type=bind,from=build,source=/package,target=/package \
    apt-get update \
    && apt-get install -y --no-install-recommends /package/*.deb \
    && rm -rf /var/lib/apt/lists/*
WORKDIR /pictures
ENTRYPOINT ["blackhole"]
